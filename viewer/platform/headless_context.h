// What the contexts without a display have in common: a size that the caller sets and a clock that the caller turns.
#pragma once
#include "platform/context.h"

namespace pliant::viewer {

class HeadlessContext : public Context {
public:
    Size framebuffer_size() const override { return size_; }

    void gui_attach() override;
    void gui_begin_frame(Real dt) override;  // throws Refused unless dt > 0
    void gui_detach() override;

protected:
    explicit HeadlessContext(Size size) : size_(size) {}
    Size size_;
};

}  // namespace pliant::viewer
