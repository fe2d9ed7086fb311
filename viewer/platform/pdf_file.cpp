#include "platform/pdf_file.h"

#include <hpdf.h>
#include <pliant/math/error.h>

#include <fmt/format.h>

#include <algorithm>

namespace pliant::viewer {
namespace {

constexpr float page_width = 960;  // 1/72 inch: of a page, whatever the picture's pixels

HPDF_Doc doc(void* document) { return static_cast<HPDF_Doc>(document); }

}  // namespace

PdfFile::PdfFile(const std::string& title) : document_(HPDF_New(nullptr, nullptr)) {
    if (!document_) throw Refused("a PDF file cannot be begun: there is not enough memory");
    HPDF_SetCompressionMode(doc(document_), HPDF_COMP_ALL);
    HPDF_SetInfoAttr(doc(document_), HPDF_INFO_TITLE, title.c_str());
    check("begun");
}

PdfFile::~PdfFile() { HPDF_Free(doc(document_)); }

void PdfFile::check(std::string_view what) const {
    if (const HPDF_STATUS status = HPDF_GetError(doc(document_)); status != HPDF_OK)
        throw Refused(fmt::format("the PDF file cannot be {}: libharu's error {:#06x}", what, status));
}

void PdfFile::add_page(const Image& image) {
    const auto width = static_cast<HPDF_UINT>(image.width), height = static_cast<HPDF_UINT>(image.height);
    HPDF_Image picture = HPDF_LoadRawImageFromMem(doc(document_), image.rgb.data(), width, height, HPDF_CS_DEVICE_RGB, 8);
    check("given a picture");
    HPDF_Page page = HPDF_AddPage(doc(document_));
    const float page_height = page_width * static_cast<float>(height) / static_cast<float>(width);
    HPDF_Page_SetWidth(page, page_width);
    HPDF_Page_SetHeight(page, page_height);
    HPDF_Page_DrawImage(page, picture, 0, 0, page_width, page_height);
    check("given a page");
    ++pages_;
}

std::string PdfFile::bytes() const {
    if (pages_ == 0) throw Refused("a PDF file without a page is none");
    HPDF_SaveToStream(doc(document_));
    check("written");
    std::string all(HPDF_GetStreamSize(doc(document_)), '\0');
    HPDF_ResetStream(doc(document_));
    for (std::size_t at = 0; at < all.size();) {
        auto count = static_cast<HPDF_UINT32>(std::min<std::size_t>(all.size() - at, 1u << 20));
        HPDF_ReadFromStream(doc(document_), reinterpret_cast<HPDF_BYTE*>(all.data() + at), &count);
        if (count == 0) break;
        at += count;
    }
    return all;
}

}  // namespace pliant::viewer
