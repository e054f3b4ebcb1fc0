// SPDX-License-Identifier: MIT
// The number of an invocation where work groups of 64 stand in rows, as more are asked for than a row may have.
uint indexInRows() { return gl_GlobalInvocationID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x; }
