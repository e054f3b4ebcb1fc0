// SPDX-License-Identifier: MIT
// Where the OpenGL passes bind what their shaders read. Read by C++ and by GLSL.
#ifndef LIXEL_SHARED_GL_SLOTS_H
#define LIXEL_SHARED_GL_SLOTS_H
#include "lixel/shared/glsl.h"

LX_SHARED_BEGIN

// Vertex attributes of surfaces.
const int kAttributePosition = 0;
const int kAttributeUv = 1;
const int kAttributeColour = 2;
const int kAttributeNormal = 3;
const int kAttributeInstance = 4; // of casters from buffers: CasterInstance, one an instance

// Shader storage buffers.
const int kStorageIndices = 0;
const int kStoragePositions = 1;
const int kStorageTriangleSource = 2;
const int kStorageTriangleMaterial = 3;
const int kStorageMaterials = 4;
const int kStoragePoints = 5;
const int kStorageVisibility = 6;
const int kStorageRegions = 7;
const int kStorageLights = 8;
const int kStorageHalfSpaces = 9;
const int kStorageShadingLights = 10;
const int kStorageCells = 11;
const int kStorageSdsm = 12;
const int kStorageSdsmCasters = 13;
const int kStorageWarps = 14;
const int kStorageUv = 15;
const int kStorageColours = 16;
const int kStorageWarpBounds = 17;
const int kStorageWarpRays = 18;
const int kStorageWarpSpans = 19;
const int kStorageWarpQueues = 20;
const int kStorageWarpQueued = 21;
const int kStorageWarpDepths = 22;
const int kStorageWarpRuns = 23;
const int kStorageImportance = 24;
const int kStorageWeights = 25;
const int kStorageLineSums = 26;
const int kStorageNearest = 27;
const int kStorageFacing = 28;
const int kStorageEdges = 29;
const int kStorageEdgeUses = 30;
const int kStorageSides = 31;
const int kStorageSideDraw = 32;

// Uniform buffers.
const int kUniformView = 0;
const int kUniformBatch = 1;
const int kUniformSdsm = 2;
const int kUniformRegion = 3;
const int kUniformWarpRaster = 4;
const int kUniformWarpFill = 5;

// Texture units.
const int kUnitSurface = 0;
const int kUnitTriangles = 1;
const int kUnitBaseColour = 2;
const int kUnitNormal = 3;
const int kUnitAtlas = 4;
const int kUnitHardware = 5;
const int kUnitWords = 6;
const int kUnitMoreWords = 7;
const int kUnitGradients = 8;
const int kUnitMoments = 9;
const int kUnitVolumes = 10;
const int kUnitSamples = 11;

// Image units.
const int kImagePicture = 0;
const int kImagePrepared = 1;
const int kImageMoreWords = 2;

LX_SHARED_END

#endif
