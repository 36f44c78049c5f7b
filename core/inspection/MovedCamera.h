// Describes a camera near a given start camera by parameters that can be fitted. Private to this
// folder.
#pragma once

#include "inspection/PartCamera.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace dipwright {

// Returns how many of k1 and k2 can be fitted to this number of pairs.
inline int fittableDistortions(std::size_t pairs) {
    return int(std::min<std::size_t>(2, pairs / pairsForDistortion));
}

// The parameters are changes of the start camera. First comes the logarithm of the factor on the
// focal length. Then come the changes of k1 and k2, as far as `distortions` (0 … 2) says. Each
// photo adds a rotation vector and a shift divided by the distance. A held camera has no
// parameters.
class MovedCamera {
public:
    MovedCamera(const PartView& start, int distortions, bool isHeld = false)
        : start_(start), distortions_(distortions), isHeld_(isHeld) {}

    Eigen::Index count() const {
        return isHeld_ ? 0 : firstPose() + 6 * Eigen::Index(start_.photos.size());
    }

    PartView view(const Eigen::Ref<const Eigen::VectorXd>& by) const {
        PartView view = start_;
        if (isHeld_) {
            return view;
        }
        view.focalLength.value *= std::exp(by[0]);
        view.lens.k1 += distortions_ > 0 ? by[1] : 0;
        view.lens.k2 += distortions_ > 1 ? by[2] : 0;
        for (std::size_t photo = 0; photo < view.photos.size(); ++photo) {
            const Eigen::Index at = firstPose() + 6 * Eigen::Index(photo);
            const Eigen::Vector3d turn = by.segment<3>(at);
            PartPose& pose = view.photos[photo];
            if (const double angle = turn.norm(); angle > 0) {
                pose.turn = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix() * pose.turn;
            }
            pose.shift += by.segment<3>(at + 3) * start_.photos[photo].shift.norm();
        }
        return view;
    }

private:
    Eigen::Index firstPose() const { return 1 + distortions_; }

    const PartView& start_;
    int distortions_;
    bool isHeld_;
};

} // namespace dipwright
