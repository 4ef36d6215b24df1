#!/usr/bin/env bash
# Runs a program under its own virtual display with software OpenGL.
exec xvfb-run -a -s "-screen 0 1600x1000x24" env QT_QPA_PLATFORM=xcb LIBGL_ALWAYS_SOFTWARE=1 "$@"
