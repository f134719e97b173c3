"""The walker's parts: mesh tools, body, head, rig and clips."""
