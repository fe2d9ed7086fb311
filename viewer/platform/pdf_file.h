// Pictures as the pages of a PDF file.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "platform/image.h"

namespace pliant::viewer {

// A document with a page for each picture, whole pages wide 16:9 or as the picture is, in the order in which they are added. The
// same pictures give the same bytes.
class PdfFile {
public:
    // Throws Refused when the library that writes it cannot begin.
    explicit PdfFile(const std::string& title);
    ~PdfFile();
    PdfFile(const PdfFile&) = delete;
    PdfFile& operator=(const PdfFile&) = delete;

    // Throws Refused when it cannot be taken.
    void add_page(const Image& image);
    // The whole file. Throws Refused without a page.
    std::string bytes() const;

private:
    void check(std::string_view what) const;
    void* document_ = nullptr;  // HPDF_Doc
    int pages_ = 0;
};

}  // namespace pliant::viewer
