#include "workbench/view/DipScene.h"

#include "base/Error.h"
#include "dip/FilmMarks.h"
#include "dip/PathKeys.h"
#include "dip/Pose.h"
#include "film/FilmGrid.h"
#include "marks/MaskColour.h"
#include "pipeline/PrintedBody.h"
#include "results/Results.h"
#include "texture/Chessboard.h"
#include "workbench/accuracy/ZoneAppearance.h"
#include "workbench/widgets/Theme.h"

#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

namespace dipwright {

namespace {

constexpr QRgb bareFilm = 0xfff4f7fa;

QSize pictureSize(const solver::FilmGrid& grid) {
    const double pixels = 1400 / std::max(grid.width, grid.depth);
    return (QSizeF(grid.width, grid.depth) * pixels).toSize();
}

// Draws plain film with a line every centimetre, so that its deformation is visible.
QImage linedFilm(const solver::FilmGrid& grid) {
    QImage picture(pictureSize(grid), QImage::Format_RGB32);
    picture.fill(bareFilm);
    QPainter painter(&picture);
    painter.translate(picture.width() / 2.0, picture.height() / 2.0);
    painter.scale(picture.width() / grid.width, picture.height() / grid.depth);
    const int columns = int(grid.width / 20), rows = int(grid.depth / 20);
    for (int line = -columns; line <= columns; ++line) {
        painter.setPen(QPen(line == 0 ? QColor(0x4a, 0x6b, 0x8a) : QColor(0x8f, 0xa5, 0xb8),
                            line == 0 ? 0.7 : 0.4));
        painter.drawLine(QPointF(line * 10, -grid.depth), QPointF(line * 10, grid.depth));
    }
    for (int line = -rows; line <= rows; ++line) {
        painter.setPen(QPen(line == 0 ? QColor(0x4a, 0x6b, 0x8a) : QColor(0x8f, 0xa5, 0xb8),
                            line == 0 ? 0.7 : 0.4));
        painter.drawLine(QPointF(-grid.width, line * 10), QPointF(grid.width, line * 10));
    }
    return picture;
}

QImage onBareFilm(const QImage& printed, const solver::FilmGrid& grid) {
    QImage picture(pictureSize(grid), QImage::Format_RGB32);
    picture.fill(bareFilm);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(picture.rect(), printed);
    return picture;
}

// Returns the longest side of a triangle that is drawn. This is a quick test for drawing, not the
// criterion for torn film (PrincipalStretch::isTorn). Live frames are drawn while the solver runs,
// from a thinned film whose triangles differ from the real ones. Triangles between released film
// and film on the body must be hidden too.
float longestDrawnSide(const solver::FilmGrid& grid, const ThinnedFilm& film, double tearStretch) {
    const auto rest = [&](int column, int row) {
        return restPosition(grid, film.points[std::size_t(row * film.columns + column)]);
    };
    Eigen::Vector2f largest = Eigen::Vector2f::Zero();
    for (int column = 1; column < film.columns; ++column) {
        largest.x() = std::max(largest.x(), rest(column, 0).x() - rest(column - 1, 0).x());
    }
    for (int row = 1; row < film.rows; ++row) {
        largest.y() = std::max(largest.y(), rest(0, row).y() - rest(0, row - 1).y());
    }
    return float(tearStretch) * largest.norm();
}

FilmShape shapeOfGrid(const solver::FilmGrid& grid, const ThinnedFilm& film, double tearStretch) {
    FilmShape shape;
    shape.longestSide = longestDrawnSide(grid, film, tearStretch);
    shape.texture.reserve(film.points.size());
    for (const std::uint32_t point : film.points) {
        const Eigen::Vector2f rest = restPosition(grid, point);
        shape.texture.emplace_back(rest.x() / float(grid.width) + 0.5f,
                                   rest.y() / float(grid.depth) + 0.5f);
    }
    for (int row = 0; row + 1 < film.rows; ++row) {
        for (int column = 0; column + 1 < film.columns; ++column) {
            const auto first = std::uint32_t(row * film.columns + column);
            const auto below = first + std::uint32_t(film.columns);
            shape.triangles.push_back({first, below, below + 1});
            shape.triangles.push_back({first, below + 1, first + 1});
        }
    }
    return shape;
}

std::vector<float> flatPositions(const solver::FilmGrid& grid, const ThinnedFilm& film) {
    std::vector<float> positions;
    positions.reserve(film.points.size() * 3);
    for (const std::uint32_t point : film.points) {
        const Eigen::Vector2f rest = restPosition(grid, point);
        positions.insert(positions.end(), {rest.x(), 0, rest.y()});
    }
    return positions;
}

constexpr std::size_t setupPoints = 2500;

} // namespace

DipScene::DipScene(DipView& view, QObject* parent) : QObject(parent), view_(view) {
    connect(&view, &DipView::pinClicked, this,
            [this](int pin) { emit pinClicked(shownPins_[std::size_t(pin)]); });
    connect(
        &printer_, &FinishedPartPreview::printed, this,
        [this](const std::shared_ptr<const TexturedMesh>& model, const BodyAppearance& appearance) {
            if (bodyLook_ == BodyLook::Print && model == project_.model) {
                showBody(appearance);
            }
        });
    connect(&artworkPainter_, &ArtworkPainter::painted, this,
            [this](const std::shared_ptr<const TexturedMesh>& model,
                   const std::shared_ptr<const TexturedMesh>& look) {
                if (model == project_.model && !project_.artwork.isEmpty()) {
                    const bool isShown = shown_.model == own_;
                    own_ = look;
                    if (isShown) {
                        showBody({own_, shown_.colours, shown_.legend, shown_.lines});
                    }
                }
            });
}

void DipScene::paintArtwork() {
    if (!project_.artwork.isEmpty()) {
        artworkPainter_.paint(project_.model, project_.artwork);
    } else if (own_ != project_.model) {
        const bool isShown = shown_.model == own_;
        own_ = project_.model;
        if (isShown) {
            showBody({own_, shown_.colours, shown_.legend, shown_.lines});
        }
    }
}

void DipScene::setProject(const Project& project, std::size_t immersion) {
    const bool otherModel = project.model != project_.model;
    const bool otherArtwork = project.artwork != project_.artwork;
    const bool otherMarks = project.share.marks != project_.share.marks;
    const bool otherMasks = project.masks != project_.masks;
    const bool otherZones = project.tolerance != project_.tolerance;
    const bool otherBase = project.baseColour != project_.baseColour;
    const bool otherFilm = !(project.film == project_.film) || !project_.model;
    project_ = project;
    const std::size_t before = immersion_;
    immersion_ = std::min(immersion, project.immersions.size() - 1);
    if (immersion_ != before) {
        setCradles(cradles_);
    }
    if (otherModel) {
        modelBox_ = boundingBox(project.model->mesh);
        queryBuilding_.wait();
        queryBuilding_.run([this, model = project.model] {
            query_ = std::make_unique<SurfaceQuery>(model->mesh);
        });
        marks_.reset();
        zones_ = nullptr;
        preview_ = nullptr;
        own_ = project.model;
        showBody({own_, {}});
    } else if (otherMarks) {
        showLines();
    }
    if (otherModel || otherMasks) {
        showMasks();
    }
    if (otherModel || otherArtwork) {
        paintArtwork();
    }
    if (otherModel || otherFilm) {
        const solver::FilmGrid grid = filmGrid(project.film);
        const double height = double(modelBox_.diagonal().norm());
        view_.setTank({grid.width, grid.depth}, std::max(40.0, 0.8 * height));
        filmSource_ = {};
    }
    if ((bodyLook_ == BodyLook::Zones && (otherModel || otherZones)) ||
        (bodyLook_ != BodyLook::Zones && !otherModel && otherBase)) {
        updateBody();
    }
    if (moment_ == Moment::Setup) {
        showSetup();
    }
    if (previewed_) {
        showPreview();
    }
    if (otherModel) {
        view_.fitBodyToHandle();
    }
}

void DipScene::setResult(std::shared_ptr<const JobResult> result,
                         std::shared_ptr<const FilmReadout> reading) {
    if (result_ != result) {
        deeper_ = nullptr;
        asksForDeeper_ = true;
    }
    result_ = std::move(result);
    reading_ = std::move(reading);
    filmSource_ = {};
    if (!previewed_) { // else the preview stays until the body is released
        updateBody();
    }
}

double DipScene::depthAt(double travelled) const {
    if (placedOn_.isStraightDown() || !project_.model) {
        return travelled - startHeight;
    }
    const Eigen::Isometry3d toWorld =
        placeOnPath(placedOn_, std::min(travelled, placedOn_.poses.back().travelled)) * placedPose_;
    return -lowestPoint(project_.model->mesh, toWorld);
}

void DipScene::placeBody(const Immersion& immersion, double descent, const solver::BodyPath* own,
                         std::optional<std::size_t> key) {
    if (!project_.model) {
        return;
    }
    descent_ = descent;
    const Eigen::Isometry3d pose = poseTransform(project_.model->mesh, immersion);
    placedOn_ = own ? *own : pathOf(immersion, pose);
    placedPose_ = pose;
    const double travel = placedOn_.isStraightDown() ? descent : placedOn_.poses.back().travelled;
    modelToWorld_ = poseToWorld(placedOn_, immersion, std::min(descent, travel)) * pose;
    shownPose_ = {key, Eigen::Matrix3d::Identity()};
    if (!placedOn_.isStraightDown()) {
        shownPose_.turn = placeOnPath(placedOn_, std::min(descent, travel)).linear();
    }
    view_.setBodyTransform(modelToWorld_);
    showPins();
    showCradle();
    const BoundingBox& box = modelBox_;
    const Eigen::Vector3f centre = (modelToWorld_ * box.center().cast<double>()).cast<float>();
    const double radius = 0.58 * double(box.diagonal().norm());
    const bool isHeld = handles_ && !brushed_ && moment_ == Moment::Setup; // while it can be placed
    view_.setRotationRings(isHeld, centre, radius);
    const std::vector<PathKey>& keys = immersion.path.keys;
    const bool isInnerKey = key && *key + 1 < keys.size();
    const bool hasDepth =
        isInnerKey ? *key > 0 && keys[*key].depth.has_value() : project_.process.depth.has_value();
    view_.setMoveArrows({isHeld, isHeld && hasDepth, isHeld}, centre, 1.08 * radius, 1.4 * radius);
    setBodyRoom(Eigen::Translation3d(poseToWorld(immersion, 0)) * pose);
}

void DipScene::placeBeforeDip() {
    const Immersion& immersion = project_.immersions[immersion_];
    double travelled = 0;
    std::optional<std::size_t> key;
    if (immersion.path.kind == PathKind::Poses && pathKey_ >= 0 &&
        std::size_t(pathKey_) < immersion.path.keys.size()) {
        const TriangleMesh& mesh = project_.model->mesh;
        const Eigen::Isometry3d pose = poseTransform(mesh, immersion);
        if (const solver::BodyPath& path = pathOf(immersion, pose); !path.isStraightDown()) {
            key = std::size_t(pathKey_);
            const double time =
                immersion.path.acceleration
                    ? timesOfKeys(transformed(mesh, pose), immersion, project_.process)[*key]
                    : immersion.path.keys[*key].time.value();
            travelled = travelledAfter(path, time);
        }
    }
    placeBody(immersion, travelled, nullptr, key);
}

std::vector<double> DipScene::travelledAtPoses() const {
    std::vector<double> travelled;
    if (result_ && immersion_ < result_->immersions.size()) {
        const ImmersionResult& result = result_->immersions[immersion_];
        const solver::BodyPath& path = result.body->path;
        if (result.immersion.path.kind == PathKind::Poses && !path.isStraightDown()) {
            for (const double time :
                 timesOfKeys(result.body->mesh, result.immersion, result_->project.process)) {
                travelled.push_back(travelledAfter(path, time));
            }
        }
    }
    return travelled;
}

const solver::BodyPath& DipScene::pathOf(const Immersion& immersion,
                                         const Eigen::Isometry3d& pose) {
    const bool isKept = pathSource_ && pathModel_ == project_.model && *pathSource_ == immersion &&
                        pathProcess_ == project_.process;
    if (!isKept) {
        pathSource_ = immersion;
        pathModel_ = project_.model;
        pathProcess_ = project_.process;
        path_ = {};
        if (!immersion.path.isStraightDown()) {
            try {
                path_ =
                    bodyPath(transformed(project_.model->mesh, pose), immersion, project_.process);
            } catch (const Error&) { // the run says what is wrong; the part goes straight down
            }
        }
    }
    return path_;
}

// From the start above the film to the same distance below the water.
void DipScene::setBodyRoom(const Eigen::Isometry3d& modelToSetup) {
    BoundingBox room;
    const BoundingBox& box = modelBox_;
    for (int corner = 0; corner < 8; ++corner) {
        room.extend((modelToSetup * box.corner(BoundingBox::CornerType(corner)).cast<double>())
                        .cast<float>());
    }
    room.extend(Eigen::Vector3f(room.min() - room.sizes().y() * Eigen::Vector3f::UnitY()));
    if (bodyRoom_.isEmpty() || !room.isApprox(bodyRoom_)) {
        bodyRoom_ = room;
        emit bodyRoomChanged();
    }
}

void DipScene::setShape(const solver::FilmGrid& grid, const ThinnedFilm& film,
                        const std::vector<float>& positions) {
    shape_ = film;
    shapeGrid_ = grid;
    view_.setFilm(shapeOfGrid(grid, film, project_.process.tearStretch), positions);
}

void DipScene::showSetup() {
    moment_ = Moment::Setup;
    if (!project_.model) {
        return;
    }
    placeBeforeDip();
    if (isDippedDrawn()) {
        drawDipped(FilmExtent::OnBody);
        return;
    }
    if (filmSource_ == FilmSource(FlatFilm::OfProject)) {
        return;
    }
    const solver::FilmGrid grid = filmGrid(project_.film);
    const ThinnedFilm film = thinFilm(grid, setupPoints);
    positions_ = flatPositions(grid, film);
    setShape(grid, film, positions_);
    view_.setFilmTransform(Eigen::Isometry3d::Identity());
    filmSource_ = FlatFilm::OfProject;
    updateFilm();
}

void DipScene::showFrame(const std::shared_ptr<const DipRecording>& recording,
                         const RecordedFrame& frame) {
    moment_ = Moment::Frame;
    positions_ = frame.positions;
    if (filmSource_ != FilmSource(recording)) {
        setShape(recording->grid(), recording->film(), frame.positions);
        view_.setFilmTransform(Eigen::Isometry3d::Identity());
        filmSource_ = recording;
        updateFilm();
    } else {
        view_.setFilmPositions(frame.positions);
        if (look_ == FilmLook::Stretch) {
            view_.setFilmColours(frameColours());
        }
    }
    const bool isOfResult = result_ && immersion_ < result_->immersions.size() &&
                            result_->immersions[immersion_].immersion == recording->immersion();
    placeBody(recording->immersion(), frame.descent,
              isOfResult ? &result_->immersions[immersion_].body->path : nullptr);
}

void DipScene::showEnd() {
    if (!reading_ || !result_ || immersion_ >= result_->immersions.size()) {
        return;
    }
    moment_ = Moment::End;
    const ImmersionResult& result = result_->immersions[immersion_];
    placeBody(result.immersion, dipTravel(result_->project.process, *result.body),
              &result.body->path);
    drawDipped(extent_);
}

bool DipScene::isDippedDrawn() const {
    return reading_ && fitsResult() &&
           (moment_ == Moment::End || (moment_ == Moment::Setup && showsDipped_ && wearsFilm_));
}

bool DipScene::fitsResult() const {
    return result_ && immersion_ < result_->immersions.size() &&
           result_->project.model == project_.model;
}

void DipScene::drawDipped(FilmExtent extent) {
    const ImmersionResult& result = result_->immersions[immersion_];
    if (filmSource_ != FilmSource(Dipped{reading_, extent})) {
        const DippedFilm& film = reading_->film();
        const DrapedFilm& draped = reading_->draped();
        FilmShape shape;
        for (std::size_t point = 0; point < film.positions.size(); ++point) {
            const Eigen::Vector2f rest = restPosition(film.grid, point);
            shape.texture.emplace_back(rest.x() / float(film.grid.width) + 0.5f,
                                       rest.y() / float(film.grid.depth) + 0.5f);
        }
        shape.texture = draped.onAllPoints(std::move(shape.texture));
        std::vector<float> positions;
        positions.reserve(3 * draped.positions.size());
        for (const Eigen::Vector3f& position : draped.positions) {
            positions.insert(positions.end(), position.begin(), position.end());
        }
        shape.isOnBody = extent == FilmExtent::OnBody;
        shape.longestSide = longestDrawnSide(film.grid, thinFilm(film.grid, film.grid.pointCount()),
                                             result_->project.process.tearStretch);
        shape.triangles = shownTriangles(draped, extent);
        shapeGrid_ = film.grid;
        view_.setFilm(shape, positions);
        filmSource_ = Dipped{reading_, extent};
        updateFilm();
    }
    view_.setFilmTransform(modelToWorld_ * result.body->modelToPose.inverse());
}

std::vector<FilmTriangle> DipScene::shownTriangles(const DrapedFilm& film,
                                                   FilmExtent extent) const {
    if (bodyLook_ != BodyLook::Own) { // floating film would hide the body
        return {};
    }
    std::vector<FilmTriangle> shown;
    for (std::size_t triangle = 0; triangle < film.triangles.size(); ++triangle) {
        if (extent == FilmExtent::Whole || film.painted[triangle]) {
            shown.push_back(film.triangles[triangle]);
        }
    }
    return shown;
}

void DipScene::setFilmLook(FilmLook look, const QImage& picture) {
    look_ = look;
    picture_ = picture;
    updateFilm();
}

void DipScene::setFilmExtent(FilmExtent extent) {
    extent_ = extent;
    showDippedAnew();
}

void DipScene::showDippedAnew() {
    if (isDippedDrawn()) {
        filmSource_ = {};
        drawDipped(moment_ == Moment::End ? extent_ : FilmExtent::OnBody);
    }
}

void DipScene::setShowsDipped(bool shows) {
    if (shows != std::exchange(showsDipped_, shows)) {
        showPins();
        if (moment_ == Moment::Setup) {
            showSetup();
        }
    }
}

void DipScene::setPins(std::vector<Pin> pins) {
    pins_ = std::move(pins);
    showPins();
}

void DipScene::setShowPins(bool show) {
    showsPins_ = show;
    showPins();
}

void DipScene::showPins() {
    std::vector<ViewPin> shown;
    shownPins_.clear();
    for (std::size_t pin = 0; pin < pins_.size() && showsPins_ && showsDipped_ && !brushed_;
         ++pin) {
        if (pins_[pin].dip.value_or(immersion_) == immersion_) {
            shown.push_back(pins_[pin].pin);
            shown.back().place = toWorld(shown.back().place);
            shown.back().outward = modelToWorld_.linear().cast<float>() * shown.back().outward;
            shownPins_.push_back(pin);
        }
    }
    view_.setPins(std::move(shown));
}

void DipScene::setCradles(std::shared_ptr<const std::vector<Cradle>> cradles) {
    cradles_ = std::move(cradles);
    const bool isShown = cradles_ && immersion_ < cradles_->size() &&
                         !(*cradles_)[immersion_].mesh.triangles.empty();
    view_.setCradle(
        isShown ? std::shared_ptr<const TriangleMesh>(cradles_, &(*cradles_)[immersion_].mesh)
                : nullptr);
    showCradle();
}

// The cradle moves with the body.
void DipScene::showCradle() {
    if (cradles_ && fitsResult()) {
        const Eigen::Isometry3d& toPose = result_->immersions[immersion_].body->modelToPose;
        view_.setCradleTransform(modelToWorld_ * toPose.inverse());
    }
}

void DipScene::setWearsFilm(bool wears) {
    if (wears != std::exchange(wearsFilm_, wears) && moment_ == Moment::Setup) {
        showSetup();
    }
}

void DipScene::setHeat(FilmQuantity quantity, const HeatScale& scale) {
    quantity_ = quantity;
    scale_ = scale;
    if (look_ == FilmLook::Stretch) {
        updateFilm();
    }
}

void DipScene::setBodyLook(BodyLook look) {
    bodyLook_ = look;
    asksForDeeper_ = true;
    updateBody();
    showDippedAnew();
}

void DipScene::setShownPrint(const ShownPrint& print) {
    if (print == shownPrint_) {
        return;
    }
    shownPrint_ = print;
    asksForDeeper_ = true;
    if (bodyLook_ == BodyLook::Print) {
        updateBody();
    }
}

void DipScene::setDeeperFilm(const std::shared_ptr<const JobResult>& result,
                             std::shared_ptr<const LaidFilm> film) {
    if (result == result_) {
        deeper_ = std::move(film);
        updateBody();
    }
}

void DipScene::setMarking(bool marking) {
    if (marking != marking_) {
        marking_ = marking;
        showLines();
    }
}

void DipScene::setTolerances(std::shared_ptr<const JobTolerances> tolerances) {
    if (tolerances == tolerances_) {
        return;
    }
    tolerances_ = std::move(tolerances);
    if (bodyLook_ == BodyLook::Zones) {
        updateBody();
    }
}

void DipScene::setDifference(BodyAppearance appearance) {
    difference_ = std::move(appearance);
    if (bodyLook_ == BodyLook::Difference) {
        updateBody();
    }
}

void DipScene::setPathKey(int key) {
    if (key != std::exchange(pathKey_, key) && moment_ == Moment::Setup) {
        showSetup();
    }
}

void DipScene::setShowHandles(bool show) {
    handles_ = show;
    if (moment_ == Moment::Setup) {
        showSetup();
    }
}

void DipScene::setBrushed(bool brushed) {
    if (brushed != std::exchange(brushed_, brushed)) {
        showPins();
        if (moment_ == Moment::Setup) {
            showSetup();
        }
    }
}

void DipScene::updateFilm() {
    if (!project_.model) {
        return;
    }
    colourFilm();
    if (bodyLook_ == BodyLook::Own && !previewed_) { // bare under printed film
        updateBody();
    }
}

void DipScene::colourFilm() {
    view_.setFilmColours({});
    const bool hasSheet = result_ && immersion_ < result_->immersions.size();
    switch (look_) {
    case FilmLook::Stretch:
        if (isDippedDrawn()) {
            std::vector<QRgb> colours;
            for (const float value : reading_->draped().onAllPoints(reading_->values(quantity_))) {
                colours.push_back(scale_.colour(double(value)));
            }
            view_.setFilmColours(colours);
        } else {
            view_.setFilmColours(frameColours());
        }
        return;
    case FilmLook::Sheet:
        if (hasSheet) {
            view_.setFilmPicture(
                onBareFilm(result_->immersions[immersion_].texture->image, shapeGrid_));
            return;
        }
        break;
    case FilmLook::Shares:
        if (hasSheet && result_->share) {
            const LaidFilm& laid = *result_->immersions[immersion_].laid;
            view_.setFilmPicture(
                sharePicture(laid, *result_->share, immersion_, pictureSize(shapeGrid_)));
            return;
        }
        break;
    case FilmLook::Chessboard: {
        solver::FilmGrid printed = shapeGrid_;
        printed.width = project_.film.width.value();
        printed.depth = project_.film.height.value();
        view_.setFilmPicture(chessboard(printed, chessSquare, pictureSize(shapeGrid_)));
        return;
    }
    case FilmLook::Picture:
        if (!picture_.isNull()) {
            view_.setFilmPicture(onBareFilm(picture_, shapeGrid_));
            return;
        }
        break;
    case FilmLook::Lines:
        break;
    }
    view_.setFilmPicture(linedFilm(shapeGrid_));
}

// Colours the film by the mean stretch of the thinned film's threads, the only stretch known during
// the dip.
std::vector<QRgb> DipScene::frameColours() const {
    std::vector<QRgb> colours(shape_.points.size());
    const auto at = [this](int column, int row) {
        return Eigen::Map<const Eigen::Vector3f>(
            &positions_[std::size_t(row * shape_.columns + column) * 3]);
    };
    const auto rest = [this](int column, int row) {
        return restPosition(shapeGrid_, shape_.points[std::size_t(row * shape_.columns + column)]);
    };
    for (int row = 0; row < shape_.rows; ++row) {
        for (int column = 0; column < shape_.columns; ++column) {
            float sum = 0;
            int count = 0;
            for (const auto& [c, r] : {std::pair(column - 1, row), std::pair(column + 1, row),
                                       std::pair(column, row - 1), std::pair(column, row + 1)}) {
                if (c >= 0 && r >= 0 && c < shape_.columns && r < shape_.rows) {
                    sum += (at(c, r) - at(column, row)).norm() /
                           (rest(c, r) - rest(column, row)).norm();
                    ++count;
                }
            }
            colours[std::size_t(row * shape_.columns + column)] =
                scale_.colour(double(sum) / count);
        }
    }
    return colours;
}

void DipScene::updateBody() {
    if (bodyLook_ == BodyLook::Zones && project_.model) {
        showZones();
    } else if (bodyLook_ == BodyLook::Difference) {
        showBody(difference_);
    } else if (bodyLook_ == BodyLook::Own || !result_ || result_->project.model != project_.model ||
               immersion_ >= result_->immersions.size()) {
        showBody(isPrintDrawn() ? bareAppearance(own_, ground().base) : BodyAppearance{own_, {}});
    } else if (bodyLook_ == BodyLook::Print) {
        print();
    } else if (result_->share) {
        if (shared_ != result_->share) {
            shared_ = result_->share;
            sharedBody_ = plainBody(*shared_->fade.mesh);
        }
        showBody(shareAppearance(sharedBody_, *result_));
    } else {
        showBody(coverageAppearance(project_.model, *result_->immersions[immersion_].coverage));
    }
}

void DipScene::print() {
    const JobResult& result = *result_;
    std::vector<FilmAppearance> films = filmAppearances(result.immersions, true);
    for (std::size_t dip = 0; dip < films.size(); ++dip) {
        const PosedBody& body = *result.immersions[dip].body;
        if (body.path.isStraightDown()) { // else places above the water may have been below it
            films[dip].depth = dipDepth(result.project.process, body);
        }
    }
    if (films.size() > 1) {
        slip(films.back());
        films.resize(std::min(films.size(), shownPrint_.dips));
    }
    const SheetInputs& inputs = result.immersions.front().inputs;
    printer_.print(project_.model, std::move(films), inputs.texture.printedInk(), ground());
}

Ground DipScene::ground() const {
    return groundOf(result_->immersions.front().inputs.settings, project_.baseColour);
}

bool DipScene::isPrintDrawn() const {
    return look_ == FilmLook::Sheet && isDippedDrawn();
}

void DipScene::slip(FilmAppearance& film) {
    film.slip = shownPrint_.slip;
    if (film.slip.deeper.value() <= 0) {
        return;
    }
    if (deeper_) {
        film.laid = deeper_;
        return;
    }
    film.slip.deeper = Millimetres(0); // until that film is computed
    if (result_->project.process.depth && std::exchange(asksForDeeper_, false)) {
        emit deeperFilmWanted(result_);
    }
}

void DipScene::setPreviewed(bool previewed) {
    if (previewed == previewed_) {
        return;
    }
    previewed_ = previewed && project_.model;
    if (previewed_) {
        showPreview();
    } else {
        updateBody();
    }
}

void DipScene::showPreview() {
    if (!preview_) {
        preview_ = std::make_unique<CoveragePreview>(project_.model->mesh);
        previewedBody_ = plainBody(preview_->mesh());
    }
    const Immersion& immersion = project_.immersions[immersion_];
    showBody(previewAppearance(previewedBody_,
                               preview_->at(immersion, project_.film, project_.process).covered));
}

void DipScene::showZones() {
    if (!zones_) {
        zones_ = std::make_unique<ZonedBody>(project_.model);
        zonedBody_ = plainBody(zones_->mesh());
    }
    zones_->setMarks(project_.tolerance.marks);
    showBody(zoneAppearance(zonedBody_, *zones_, tolerances_.get(), project_.tolerance));
}

void DipScene::showMasks() {
    mask_ = surfaceMask(project_.model, project_.masks, mask_);
    ViewPatch patch{{}, maskColour};
    for (const MarkedPiece& piece : mask_ ? mask_->pieces() : std::vector<MarkedPiece>()) {
        patch.triangles.push_back(piece.corners);
    }
    view_.setBodyPatch(PatchLayer::Masks, std::move(patch));
    showLegend();
}

void DipScene::setStroke(ViewPatch patch) {
    view_.setBodyPatch(PatchLayer::Stroke, std::move(patch));
}

void DipScene::showLegend() {
    std::vector<ViewLegendEntry> legend = shown_.legend;
    if (mask_) {
        legend.push_back({maskColour, tr("Mask: stays free of film")});
    }
    view_.setLegend(std::move(legend));
}

void DipScene::showBody(BodyAppearance appearance) {
    if (appearance.model != shown_.model) {
        view_.setBody(appearance.model);
    }
    shown_ = std::move(appearance);
    view_.setBodyColours(shown_.colours);
    showLegend();
    showLines();
}

void DipScene::showLines() {
    std::vector<ViewLine> lines = shown_.lines;
    const bool shows = marking_ || bodyLook_ == BodyLook::Coverage;
    if (shows && !project_.share.marks.empty()) {
        if (!marks_) {
            marks_.emplace(project_.model->mesh);
        }
        const std::vector<ViewLine> marks = marks_->lines(project_.share.marks);
        lines.insert(lines.end(), marks.begin(), marks.end());
    }
    lines.insert(lines.end(), frame_.begin(), frame_.end());
    view_.setBodyLines(lines);
}

void DipScene::setFrame(std::vector<ViewLine> frame) {
    if (!frame.empty() || !frame_.empty()) {
        frame_ = std::move(frame);
        showLines();
    }
}

std::optional<Eigen::Isometry3d> DipScene::worldToEnd() const {
    if (!isDippedDrawn()) {
        return std::nullopt;
    }
    const ImmersionResult& result = result_->immersions[immersion_];
    return result.body->modelToPose * modelToWorld_.inverse();
}

std::optional<Eigen::Vector3f> DipScene::modelPoint(const ViewRay& ray) const {
    const std::optional<SurfacePoint> point = modelSurface(ray);
    return point ? std::optional(position(project_.model->mesh, *point)) : std::nullopt;
}

const SurfaceQuery* DipScene::query() const {
    queryBuilding_.wait();
    return query_.get();
}

std::optional<SurfacePoint> DipScene::modelSurface(const ViewRay& ray) const {
    if (!project_.model) {
        return std::nullopt;
    }
    const Eigen::Isometry3f worldToModel = modelToWorld_.inverse().cast<float>();
    const RayHit hit =
        query()->hit(worldToModel * ray.origin, worldToModel.linear() * ray.direction);
    return hit.point.isValid() ? std::optional(hit.point) : std::nullopt;
}

Eigen::Vector3f DipScene::toModel(const Eigen::Vector3f& worldPoint) const {
    return modelToWorld_.inverse().cast<float>() * worldPoint;
}

SurfacePoint DipScene::nearestSurface(const Eigen::Vector3f& modelPoint) const {
    return query()->closest(modelPoint).point;
}

void DipScene::lookAt(const Eigen::Vector3f& modelPoint) {
    if (!project_.model) {
        return;
    }
    const SurfacePoint point = nearestSurface(modelPoint);
    const Eigen::Vector3f outward = triangleNormal(project_.model->mesh, point.triangle);
    const Eigen::Vector3f world = toWorld(modelPoint);
    view_.setMarker(world);
    view_.lookAt(world, toWorld(modelPoint + outward) - world);
}

Eigen::Vector3f DipScene::toWorld(const Eigen::Vector3f& modelPoint) const {
    return modelToWorld_.cast<float>() * modelPoint;
}

} // namespace dipwright
