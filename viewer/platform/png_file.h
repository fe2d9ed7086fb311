// Pictures as PNG files.
#pragma once
#include <filesystem>
#include <string>

#include "platform/image.h"

namespace pliant::viewer {

// Writes the whole file or nothing: it appears under its name only when complete. The same picture gives the same bytes. Throws
// Refused, which names the path, when it cannot be written.
void write_png(const Image& image, const std::filesystem::path& path);

// The bytes of such a file.
std::string png_bytes(const Image& image);

// Reads any PNG as 8 bits per colour, laid over black where transparent. Throws Refused, which names the path, when it cannot be
// read, is no PNG or has a side above 32768 px.
Image read_png(const std::filesystem::path& path);

}  // namespace pliant::viewer
