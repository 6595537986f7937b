"""Many machines: a hub on each, one of which the others dial, and classes of students on top."""
