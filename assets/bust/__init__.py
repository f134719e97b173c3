"""The parts of face.py's head; numpy only, Blender is not needed."""
