// A value that is computed when it is asked for and what it depends on has changed.
#pragma once
#include <optional>
#include <utility>

namespace pliant {

template <class Key, class Value>
class Remembered {
public:
    // make: gives the value that belongs to the key.
    template <class Make>
    const Value& of(Key key, Make&& make) {
        if (key_ != key) {
            value_ = make();
            key_ = std::move(key);
        }
        return value_;
    }
    void forget() { key_.reset(); }

private:
    std::optional<Key> key_;
    Value value_{};
};

}  // namespace pliant
