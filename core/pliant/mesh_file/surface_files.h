// Surfaces of triangles: Wavefront .obj, and .stl as text or binary.
#pragma once
#include <pliant/mesh_file/mesh_file.h>

namespace pliant {

// Points that are the same to the bit are one. Both throw Refused naming the path and the line, or the byte of a binary file.

// Faces of more than three corners are cut into triangles from the first corner; groups (g) and objects (o) keep their names.
// Points and faces count from 1.
MeshFile parse_obj(std::string_view bytes, std::string_view path);
// Triangles count from 0; normals are left out, the order of the corners tells what is outside.
MeshFile parse_stl(std::string_view bytes, std::string_view path);

}  // namespace pliant
