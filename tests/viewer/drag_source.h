// What other programs say to a window through the X server: a window manager that closes it, a file manager
// that drops files on it.
//
// To be included last: Xlib's macros collide with names of other headers.
#pragma once

#include "tests/viewer/real_window.h"

#if __has_include(<X11/Xlib.h>)
#include <X11/Xlib.h>
#define GLINT_TEST_HAS_XLIB 1
#else
#define GLINT_TEST_HAS_XLIB 0
#endif

namespace glint::test {

#if GLINT_TEST_HAS_XLIB
/// What a window manager sends when its close button is clicked.
inline void askToClose(const std::string& display, unsigned long window) {
    ::Display* connection = XOpenDisplay(display.c_str());
    ASSERT_NE(connection, nullptr);
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = window;
    event.xclient.message_type = XInternAtom(connection, "WM_PROTOCOLS", False);
    event.xclient.format = 32;
    event.xclient.data.l[0] = static_cast<long>(XInternAtom(connection, "WM_DELETE_WINDOW", False));
    event.xclient.data.l[1] = CurrentTime;
    XSendEvent(connection, window, False, NoEventMask, &event);
    XCloseDisplay(connection);
}

/// Another program that files are dragged from, by the XDND protocol (version 5, as a file manager
/// speaks it).
class DragSource {
  public:
    explicit DragSource(const std::string& display) : display_(XOpenDisplay(display.c_str())) {
        window_ = XCreateSimpleWindow(display_, DefaultRootWindow(display_), 0, 0, 1, 1, 0, 0, 0);
    }
    DragSource(const DragSource&) = delete;
    DragSource& operator=(const DragSource&) = delete;
    ~DragSource() { XCloseDisplay(display_); }

    /// Drops what `uriList` names in the target's middle; true when the target said that it took it.
    bool drop(::Window target, const std::string& uriList) {
        XSetSelectionOwner(display_, atom("XdndSelection"), window_, CurrentTime);
        const long list = static_cast<long>(atom("text/uri-list"));
        say(target, "XdndEnter", {5L << 24, list, 0, 0});
        const long copy = static_cast<long>(atom("XdndActionCopy"));
        say(target, "XdndPosition", {0, (300L << 16) | 300, CurrentTime, copy});
        if (!answered("XdndStatus", uriList)) { return false; }
        say(target, "XdndDrop", {0, CurrentTime, 0, 0});
        return answered("XdndFinished", uriList);
    }

  private:
    Atom atom(const char* name) { return XInternAtom(display_, name, False); }

    void say(::Window target, const char* message, const std::array<long, 4>& data) {
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.window = target;
        event.xclient.message_type = atom(message);
        event.xclient.format = 32;
        event.xclient.data.l[0] = static_cast<long>(window_);
        for (size_t i = 0; i < data.size(); ++i) {
            event.xclient.data.l[i + 1] = data[i];
        }
        XSendEvent(display_, target, False, NoEventMask, &event);
        XFlush(display_);
    }

    /// Hands out the list when asked, until the answer arrives that is waited for.
    bool answered(const char* message, const std::string& uriList) {
        const Atom wanted = atom(message);
        bool isThere = false;
        return until([&] {
            while (!isThere && XPending(display_) > 0) {
                XEvent event{};
                XNextEvent(display_, &event);
                if (event.type == SelectionRequest) { handOut(event.xselectionrequest, uriList); }
                isThere = event.type == ClientMessage && event.xclient.message_type == wanted;
            }
            return isThere;
        });
    }

    void handOut(const XSelectionRequestEvent& request, const std::string& uriList) {
        XChangeProperty(display_, request.requestor, request.property, request.target, 8, PropModeReplace,
                        reinterpret_cast<const unsigned char*>(uriList.data()),
                        static_cast<int>(uriList.size()));
        XEvent event{};
        event.xselection.type = SelectionNotify;
        event.xselection.requestor = request.requestor;
        event.xselection.selection = request.selection;
        event.xselection.target = request.target;
        event.xselection.property = request.property;
        event.xselection.time = request.time;
        XSendEvent(display_, request.requestor, False, NoEventMask, &event);
        XFlush(display_);
    }

    ::Display* display_;
    ::Window window_ = 0;
};
#endif

}  // namespace glint::test
