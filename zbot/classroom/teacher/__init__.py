"""Class of a teacher: the list of students, and what the teacher's hub answers."""
