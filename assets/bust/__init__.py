"""The parts of face.py's head. They need numpy, but not Blender."""
