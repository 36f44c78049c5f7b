// Receives the motions of a SpaceMouse from the daemon spacenavd, by libspnav. Does nothing in a
// build without libspnav, and while no daemon runs.
#pragma once

#include <Eigen/Core>
#include <QObject>

namespace dipwright {

// How far the puck was pushed and turned since the last report, as shares of its full range held
// for one second. X points right, Y up, Z away from the user; turns are about these axes.
struct PuckMotion {
    Eigen::Vector3d push = Eigen::Vector3d::Zero(), turn = Eigen::Vector3d::Zero();
};

// libspnav has one connection for each process, so all views share one object. UI thread only.
class SpaceMouse : public QObject {
    Q_OBJECT

public:
    static SpaceMouse& shared();
    ~SpaceMouse() override;

signals:
    void moved(const dipwright::PuckMotion& motion);

private:
    SpaceMouse();
    void read();

    bool isConnected_ = false;
};

} // namespace dipwright
