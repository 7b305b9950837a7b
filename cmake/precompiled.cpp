// Compiled once, so that all targets share its precompiled headers (cmake/RvaTarget.cmake).
