#include "SpaceMouse.h"

#ifdef DIPWRIGHT_SPACEMOUSE
#include <QSocketNotifier>
#include <algorithm>
#include <spnav.h>
#include <sys/socket.h>
#endif

namespace dipwright {

SpaceMouse& SpaceMouse::shared() {
    static SpaceMouse mouse;
    return mouse;
}

#ifdef DIPWRIGHT_SPACEMOUSE

namespace {

// Returns whether the daemon has closed its socket. It is then always ready to be read.
bool hasEnded(int socket) {
    char next = 0;
    return socket == -1 || recv(socket, &next, 1, MSG_PEEK | MSG_DONTWAIT) == 0;
}

} // namespace

SpaceMouse::SpaceMouse() : isConnected_(spnav_open() != -1) {
    if (isConnected_) {
        auto* ready = new QSocketNotifier(spnav_fd(), QSocketNotifier::Read, this);
        connect(ready, &QSocketNotifier::activated, this, &SpaceMouse::read);
    }
}

SpaceMouse::~SpaceMouse() {
    if (isConnected_) {
        spnav_close();
    }
}

void SpaceMouse::read() {
    constexpr double fullRange = 350; // of each axis
    constexpr unsigned longest = 50;  // ms; a longer pause is none
    PuckMotion sum;
    spnav_event event;
    while (spnav_poll_event(&event) != 0) {
        if (event.type == SPNAV_EVENT_MOTION) {
            const spnav_event_motion& motion = event.motion;
            const double held = std::clamp(motion.period, 1U, longest) / 1000.0 / fullRange;
            sum.push += held * Eigen::Vector3d(motion.x, motion.y, motion.z);
            sum.turn += held * Eigen::Vector3d(motion.rx, motion.ry, motion.rz);
        }
    }
    if (!sum.push.isZero() || !sum.turn.isZero()) {
        emit moved(sum);
    } else if (hasEnded(spnav_fd())) {
        delete findChild<QSocketNotifier*>();
        spnav_close();
        isConnected_ = false;
    }
}

#else

SpaceMouse::SpaceMouse() = default;
SpaceMouse::~SpaceMouse() = default;
void SpaceMouse::read() {}

#endif

} // namespace dipwright
