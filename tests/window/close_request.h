// What a window manager does when a person closes a window: the client message WM_DELETE_WINDOW, sent over the X protocol itself
// [X11R7 protocol, version 11: connection setup, InternAtom, SendEvent; ICCCM 2.0, §4.2.8.1], since no window manager runs.
#pragma once
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace pliant::test {

class XConnection {
public:
    // display: ":7"
    explicit XConnection(const std::string& display) {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        const std::string path = "/tmp/.X11-unix/X" + display.substr(1);
        path.copy(address.sun_path, sizeof address.sun_path - 1);
        if (connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
            throw std::runtime_error("no X server at " + path);
        const char order = std::endian::native == std::endian::little ? 'l' : 'B';
        write(Words().byte(static_cast<std::uint8_t>(order)).byte(0).half(11).half(0).half(0).half(0).half(0));
        const auto head = read(8);
        read(4 * half_at(head, 6));
        if (head[0] != 1) throw std::runtime_error("the X server refuses a connection");
    }
    ~XConnection() { close(socket_); }
    XConnection(const XConnection&) = delete;
    XConnection& operator=(const XConnection&) = delete;

    void ask_to_close(std::uint32_t window) {
        const std::uint32_t protocols = atom("WM_PROTOCOLS"), delete_window = atom("WM_DELETE_WINDOW");
        constexpr std::uint8_t send_event = 25, client_message = 33;
        write(Words()
                  .byte(send_event)
                  .byte(0)
                  .half(11)
                  .word(window)
                  .word(0)
                  .byte(client_message)
                  .byte(32)
                  .half(0)
                  .word(window)
                  .word(protocols)
                  .word(delete_window)
                  .word(0)
                  .word(0)
                  .word(0)
                  .word(0));
        atom("WM_PROTOCOLS");  // once this is answered, the message has been sent
    }

private:
    class Words {
    public:
        Words& byte(std::uint8_t v) { return add(v); }
        Words& half(std::uint16_t v) { return add(v); }
        Words& word(std::uint32_t v) { return add(v); }
        Words& text(std::string_view t) {
            bytes.insert(bytes.end(), t.begin(), t.end());
            bytes.resize((bytes.size() + 3) / 4 * 4);
            return *this;
        }
        std::vector<std::uint8_t> bytes;

    private:
        template <class T>
        Words& add(T value) {
            std::array<std::uint8_t, sizeof(T)> raw;
            std::memcpy(raw.data(), &value, sizeof value);
            bytes.insert(bytes.end(), raw.begin(), raw.end());
            return *this;
        }
    };

    std::uint32_t atom(std::string_view name) {
        constexpr std::uint8_t intern_atom = 16;
        write(Words()
                  .byte(intern_atom)
                  .byte(0)
                  .half(static_cast<std::uint16_t>(2 + (name.size() + 3) / 4))
                  .half(static_cast<std::uint16_t>(name.size()))
                  .half(0)
                  .text(name));
        const auto reply = read(32);
        std::uint32_t value = 0;
        std::memcpy(&value, reply.data() + 8, sizeof value);
        return value;
    }
    void write(const Words& words) {
        if (send(socket_, words.bytes.data(), words.bytes.size(), MSG_NOSIGNAL) != static_cast<ssize_t>(words.bytes.size()))
            throw std::runtime_error("the X server is gone");
    }
    std::vector<std::uint8_t> read(std::size_t count) {
        std::vector<std::uint8_t> bytes(count);
        if (count && recv(socket_, bytes.data(), count, MSG_WAITALL) != static_cast<ssize_t>(count))
            throw std::runtime_error("the X server is gone");
        return bytes;
    }
    static std::size_t half_at(const std::vector<std::uint8_t>& bytes, std::size_t at) {
        std::uint16_t value = 0;
        std::memcpy(&value, bytes.data() + at, sizeof value);
        return value;
    }

    int socket_ = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
};

}  // namespace pliant::test
