#include "inspection/FindPrint.h"

#include "base/Error.h"
#include "base/NumberText.h"
#include "geometry/SurfaceQuery.h"
#include "inspection/RefineCorner.h"
#include "inspection/Saddles.h"
#include "parallel/ParallelFor.h"

#include <Eigen/LU>

#include <opencv2/imgproc.hpp>

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::PartCamera)
};

constexpr double leastFacing = 0.3;    // cosine between line of sight and body normal
constexpr double leastStep = 8;        // pixels to the next corner
constexpr double leastSine = 0.25;     // sine of the angle between the two steps in the photo
constexpr double firstReach = 0.6;     // steps: radius within which the first corners are searched
constexpr double nearReach = 0.35;     // steps: search radius beside a corner that was found
constexpr double leastAlike = 0.75;    // correlation with the pattern of four squares
constexpr double neighbours = 1.6;     // squares within which corners are neighbours
constexpr double mostDeviation = 0.35; // steps from the place that the neighbours suggest
constexpr double leastShare = 0.25;    // share of the expected corners that a photo must show
constexpr double mostSwapped = 0.5; // of the expected corners, if black and white are not swapped
constexpr int rounds = 3;           // repetitions of finding corners and fitting the camera to them

double median(std::vector<double> values) {
    if (values.empty()) {
        return 0;
    }
    const auto half = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), half, values.end());
    return *half;
}

// A corner at the place where the camera should see it.
struct Expected {
    std::size_t corner = 0;
    Eigen::Vector2d pixel, right, down; // `right` and `down`: steps to the next corners
};

struct Alike {
    double correlation = 0;
    Eigen::Vector2d steps =
        Eigen::Vector2d::Zero(); // offset from the start of the search, in steps
};

// Returns the correlation of the photo with four squares, alternately dark and light, that meet at
// a place. 1 is a perfect match; −1 means that black and white are swapped.
double alike(const cv::Mat& grey, const Expected& at, const Eigen::Vector2d& place, bool isDark) {
    constexpr std::array<double, 8> samples{-0.4, -0.3, -0.2, -0.1, 0.1, 0.2, 0.3, 0.4};
    double sum = 0, squares = 0, product = 0;
    for (const double down : samples) {
        for (const double right : samples) {
            const double value = greyAt(grey, place + right * at.right + down * at.down);
            sum += value;
            squares += value * value;
            product += ((right > 0) == (down > 0) ? -1 : 1) * value;
        }
    }
    constexpr double count = samples.size() * samples.size();
    constexpr double leastDeviation = 0.01; // share of white; smaller deviations are noise
    const double deviation = std::sqrt(std::max(0.0, squares / count - std::pow(sum / count, 2)));
    return (isDark ? 1 : -1) * product / count / std::max(deviation, leastDeviation);
}

// Searches a photo, given the current camera.
class PhotoSearch {
public:
    PhotoSearch(const QImage& photo, const std::vector<PrintedCorner>& corners)
        : corners_(corners), grey_(levelsOf(greyOf(photo))), size_(photo.size()) {
        cv::GaussianBlur(grey_.front(), blurred_, {}, 1);
    }

    // Returns the corners that face the camera and are not hidden by the body.
    std::vector<Expected> expected(const PartView& view, int photo,
                                   const SurfaceQuery& body) const {
        const PartPose& pose = view.photos[std::size_t(photo)];
        const Eigen::Vector3d eye = -pose.turn.transpose() * pose.shift;
        std::vector<Expected> all;
        for (std::size_t i = 0; i < corners_.size(); ++i) {
            const PrintedCorner& corner = corners_[i];
            const Eigen::Vector3d sight = corner.model - eye;
            const bool isBefore = (pose.turn * corner.model + pose.shift).z() > 0;
            if (!isBefore || -sight.normalized().dot(corner.outward) < leastFacing) {
                continue;
            }
            const float depth = body.hit(eye.cast<float>(), sight.cast<float>()).distance;
            if (double(depth) < 1 - 0.02 * corner.right.norm() / sight.norm()) {
                continue;
            }
            const auto seen = [&](const Eigen::Vector3d& place) {
                return seenAt(view, photo, size_, place);
            };
            constexpr double step = 0.25;
            Expected one{i, seen(corner.model), {}, {}};
            one.right = (seen(corner.model + step * corner.right) -
                         seen(corner.model - step * corner.right)) /
                        (2 * step);
            one.down = (seen(corner.model + step * corner.down) -
                        seen(corner.model - step * corner.down)) /
                       (2 * step);
            if (isLargeEnough(one)) {
                all.push_back(one);
            }
        }
        return all;
    }

    // Returns the best match within `reach` steps of `place`.
    Alike bestNear(const Expected& at, const Eigen::Vector2d& place, double reach,
                   bool isSwapped) const {
        constexpr double step = 0.05;
        const int count = int(std::ceil(reach / step));
        const bool isDark = corners_[at.corner].isDark != isSwapped;
        Alike best;
        for (int i = -count; i <= count; ++i) {
            for (int j = -count; j <= count; ++j) {
                const Eigen::Vector2d steps = step * Eigen::Vector2d(i, j);
                const double here =
                    alike(blurred_, at, place + steps.x() * at.right + steps.y() * at.down, isDark);
                if (steps.norm() <= reach && here > best.correlation) {
                    best = {here, steps};
                }
            }
        }
        return best;
    }

    std::optional<Eigen::Vector2d> found(const Expected& at, const Eigen::Vector2d& place,
                                         double reach, bool isSwapped) const {
        const Alike best = bestNear(at, place, reach, isSwapped);
        if (best.correlation < leastAlike) {
            return std::nullopt;
        }
        return refinedCorner(grey_, place + best.steps.x() * at.right + best.steps.y() * at.down,
                             at.right, at.down, BoardShape::Bent);
    }

private:
    bool isLargeEnough(const Expected& at) const {
        const double right = at.right.norm(), down = at.down.norm();
        const double sine =
            std::abs(at.right.x() * at.down.y() - at.right.y() * at.down.x()) / (right * down);
        const bool isIn = at.pixel.x() > right / 2 && at.pixel.y() > down / 2 &&
                          at.pixel.x() < size_.width() - right / 2 &&
                          at.pixel.y() < size_.height() - down / 2;
        return isIn && right > leastStep && down > leastStep && sine > leastSine;
    }

    const std::vector<PrintedCorner>& corners_;
    GreyLevels grey_;
    cv::Mat blurred_;
    QSize size_;
};

// Finds the corners of one photo, spreading from found corners to their neighbours. `isSwapped`:
// expects white where the print is black, and black where it is white.
class PhotoCorners {
public:
    PhotoCorners(const PhotoSearch& search, const std::vector<PrintedCorner>& corners,
                 std::vector<Expected> expected, bool isSwapped = false)
        : search_(search), corners_(corners), expected_(std::move(expected)), isSwapped_(isSwapped),
          found_(expected_.size()) {}

    void find() {
        lookFor(everything(), firstReach);
        dropStrays();
        for (std::size_t before = 0; before != count();) {
            before = count();
            lookFor(missing(), nearReach);
        }
        dropStrays();
    }

    const std::vector<Expected>& expected() const { return expected_; }
    const std::vector<std::optional<Eigen::Vector2d>>& found() const { return found_; }
    std::size_t count() const {
        return std::size_t(std::count_if(found_.begin(), found_.end(),
                                         [](const auto& place) { return place.has_value(); }));
    }
    // Returns the distances of the found corners from their expected places, in steps.
    std::vector<double> distances() const {
        std::vector<double> all;
        for (std::size_t i = 0; i < found_.size(); ++i) {
            if (found_[i]) {
                all.push_back(inSteps(i).norm());
            }
        }
        return all;
    }
    double distance() const { return median(distances()); }
    bool isEnough() const {
        return count() >= std::size_t(leastPairs) &&
               double(count()) >= leastShare * double(expected_.size());
    }

private:
    std::vector<std::size_t> everything() const {
        std::vector<std::size_t> all(expected_.size());
        for (std::size_t i = 0; i < all.size(); ++i) {
            all[i] = i;
        }
        return all;
    }

    // Returns the corners not found yet that have a found neighbour.
    std::vector<std::size_t> missing() const {
        std::vector<std::size_t> all = everything();
        std::erase_if(all, [&](std::size_t i) { return found_[i] || !moved(i); });
        return all;
    }

    void lookFor(const std::vector<std::size_t>& which, double reach) {
        std::vector<std::optional<Eigen::Vector2d>> places(which.size());
        parallelFor(std::size_t(0), which.size(), [&](std::size_t i) {
            const Expected& at = expected_[which[i]];
            const Eigen::Vector2d move = moved(which[i]).value_or(Eigen::Vector2d::Zero());
            places[i] = search_.found(at, at.pixel + move.x() * at.right + move.y() * at.down,
                                      reach, isSwapped_);
        });
        for (std::size_t i = 0; i < which.size(); ++i) {
            found_[which[i]] = places[i];
        }
    }

    // Returns the median offset of the found neighbours from their expected places, in steps.
    std::optional<Eigen::Vector2d> moved(std::size_t which) const {
        const PrintedCorner& here = corners_[expected_[which].corner];
        const double most = neighbours * std::max(here.right.norm(), here.down.norm());
        std::vector<double> right, down;
        for (std::size_t i = 0; i < expected_.size(); ++i) {
            const PrintedCorner& other = corners_[expected_[i].corner];
            if (i != which && found_[i] && other.dip == here.dip &&
                (other.model - here.model).norm() < most) {
                const Eigen::Vector2d steps = inSteps(i);
                right.push_back(steps.x());
                down.push_back(steps.y());
            }
        }
        if (right.empty()) {
            return std::nullopt;
        }
        return Eigen::Vector2d(median(right), median(down));
    }

    Eigen::Vector2d inSteps(std::size_t which) const {
        const Expected& at = expected_[which];
        Eigen::Matrix2d steps;
        steps << at.right, at.down;
        return steps.inverse() * (*found_[which] - at.pixel);
    }

    // Drops points that do not fit their neighbours or have none; they are not corners.
    void dropStrays() {
        std::vector<std::size_t> strays;
        for (std::size_t i = 0; i < expected_.size(); ++i) {
            if (found_[i]) {
                const auto beside = moved(i);
                if (!beside || (*beside - inSteps(i)).norm() > mostDeviation) {
                    strays.push_back(i);
                }
            }
        }
        for (const std::size_t stray : strays) {
            found_[stray].reset();
        }
    }

    const PhotoSearch& search_;
    const std::vector<PrintedCorner>& corners_;
    std::vector<Expected> expected_;
    bool isSwapped_;
    std::vector<std::optional<Eigen::Vector2d>> found_; // per expected corner
};

// Tells whether the corners of a print with black and white swapped match the photo better: they
// are found, and lie less than half as far from their expected places. In an inverted photo, the
// search finds most corners at the places of their neighbours.
bool isSwapped(const PhotoSearch& search, const std::vector<PrintedCorner>& corners,
               const PhotoCorners& found) {
    if (found.isEnough() && found.distance() < mostClearSteps) {
        return false;
    }
    PhotoCorners swapped(search, corners, found.expected(), true);
    swapped.find();
    return double(swapped.count()) > mostSwapped * double(found.expected().size()) &&
           (!found.isEnough() || 2 * swapped.distance() < found.distance());
}

// Returns the error text for a photo that does not show the expected corners.
QString notSeen(const PhotoCorners& corners, bool isSwapped, int photo) {
    const std::size_t should = corners.expected().size();
    if (should == 0) {
        return Text::tr("According to the places given for it, photo %1 shows none of the print; "
                        "give the places again, or photograph the dipped side")
            .arg(photo + 1);
    }
    if (isSwapped) {
        return Text::tr("In photo %1, black and white are swapped; the film was laid with its ink "
                        "side down, or shifted by one square")
            .arg(photo + 1);
    }
    return Text::tr("Photo %2 should show %1 corners, but only %3 were found; check that it shows "
                    "this job's part and print, whole and sharp, and that its places are correct")
        .arg(should)
        .arg(photo + 1)
        .arg(corners.count());
}

// Returns a sentence if corners with these distances from their expected places, in squares, may be
// others than they are taken for.
QString confusion(std::vector<double> distances) {
    const double distance = median(distances);
    return distance <= mostClearSteps
               ? QString()
               : Text::tr(
                     "The corners found are %1 of a square from their expected places (median). "
                     "Above %2, a corner may be confused with the one a diagonal away, so check "
                     "one corner on the part by hand, or use larger squares")
                     .arg(numberText(distance, 2), numberText(mostClearSteps, 2));
}

void append(const PhotoCorners& found, const std::vector<PrintedCorner>& corners, int photo,
            std::vector<PrintedPlace>& places) {
    for (std::size_t i = 0; i < found.expected().size(); ++i) {
        if (const auto& pixel = found.found()[i]) {
            const PrintedCorner& corner = corners[found.expected()[i].corner];
            places.push_back({photo, *pixel, corner.dip, corner.sheet, corner.model});
        }
    }
}

} // namespace

std::vector<PlacePair> pairsOf(const std::vector<PrintedPlace>& places) {
    std::vector<PlacePair> pairs;
    for (const PrintedPlace& place : places) {
        pairs.push_back({place.photo, place.pixel, place.model});
    }
    return pairs;
}

FoundPrint findPrint(const std::vector<QImage>& photos, const TriangleMesh& model,
                     const std::vector<PrintedCorner>& corners,
                     const std::vector<PlacePair>& clicked, const FindPrintSettings& settings,
                     const Progress& progress, const QString& where) {
    const QSize size = photos.front().size();
    const int count = int(photos.size());
    const SurfaceQuery body(model);
    FoundPrint print;
    print.view = fitPartCamera(clicked, count, size, where, settings.lens);
    std::vector<double> distances;
    for (int round = 0; round < rounds; ++round) {
        print.places.clear();
        print.expected.clear();
        for (int photo = 0; photo < count; ++photo) {
            progress(double(round * count + photo) / double(rounds * count),
                     Text::tr("Finding corners in photo %1").arg(photo + 1));
            const PhotoSearch search(photos[std::size_t(photo)], corners); // large: one at a time
            PhotoCorners found(search, corners, search.expected(print.view, photo, body));
            found.find();
            const bool swapped = isSwapped(search, corners, found);
            if (swapped || !found.isEnough()) {
                throw Error(notSeen(found, swapped, photo), where);
            }
            if (round == 0) { // later cameras may follow the print
                const std::vector<double> own = found.distances();
                distances.insert(distances.end(), own.begin(), own.end());
            }
            print.expected.push_back(int(found.expected().size()));
            append(found, corners, photo, print.places);
        }
        if (settings.keepsCamera) {
            break;
        }
        try {
            print.view = fitPartCamera(pairsOf(print.places), count, size, where, settings.lens);
            print.followsPrint = true;
        } catch (const Error&) {
            break; // the corners do not determine a camera, for example if all lie on one face
        }
    }
    print.doubt = confusion(distances);
    print.view = viewOf(print.view, pairsOf(print.places), size);
    return print;
}

} // namespace dipwright
