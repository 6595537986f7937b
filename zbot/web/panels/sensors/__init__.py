"""Panel that publishes the sensors of the browser: camera, microphone, motion and position."""
