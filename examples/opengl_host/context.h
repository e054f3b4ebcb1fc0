// SPDX-License-Identifier: MIT
#pragma once

// The host's own OpenGL 4.5 context, without a window; current on this thread until the process ends. False where there is none.
bool makeContext();

// Throws std::runtime_error, naming `what`, where OpenGL has an error flag set.
void checkErrors(const char* what);
