#include "targets.h"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    pliant::test::fuzz_mesh_file({reinterpret_cast<const char*>(data), size});
    return 0;
}
