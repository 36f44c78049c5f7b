#include "import/sandboxed/ModelSource.h"

#include "base/Budgets.h"
#include "base/Error.h"
#include "model/ModelFormats.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::ImportModel)
};

} // namespace

QImage ModelSource::readPicture(const QString& name, QStringList& warnings) const {
    const auto found = files.read(name);
    if (!found) {
        warnings.push_back(Text::tr("The texture %1 was not found beside the model; its material's "
                                    "colour is used instead")
                               .arg(name));
        return QImage();
    }
    return pictures.read(*found, Text::tr("texture %1 in %2").arg(name, path));
}

void ModelSource::throwDamaged(const QString& reason) const {
    throw Error(Text::tr("The model cannot be read: %1; save it again, or as %2")
                    .arg(reason, anyModelFormat()),
                path);
}

void ModelSource::checkTriangleCount(std::size_t count) const {
    requireWithin(Budget::Triangles, qint64(count), path, files.bytesRead());
}

bool mayBeFurtherRows(QByteArrayView left, qsizetype rowBytes) {
    return left.size() % rowBytes == 0 &&
           std::any_of(left.begin(), left.end(), [](char byte) { return byte != '\0'; });
}

bool isPastPicture(const std::array<Eigen::Vector2f, 3>& coordinates) {
    constexpr float slack = 1e-3f; // of the picture
    return std::any_of(coordinates.begin(), coordinates.end(), [](const Eigen::Vector2f& each) {
        return each.minCoeff() < -slack || each.maxCoeff() > 1 + slack;
    });
}

Eigen::Vector2f statedCoordinates(float u, float v) {
    constexpr float infinite = std::numeric_limits<float>::infinity();
    return {std::isnan(u) ? infinite : u, std::isnan(v) ? infinite : v};
}

QString notRepeatedWarning() {
    return Text::tr(
        "The model mirrors a texture past its edge, or ends it there; here it repeats, so these "
        "places are wrong. Apply this to the picture in a modelling program");
}

bool isUnit(const std::vector<double>& numbers) {
    constexpr double rounding = 0.001; // of the square
    const double square = std::inner_product(numbers.begin(), numbers.end(), numbers.begin(), 0.0);
    return std::abs(square - 1) <= rounding;
}

void FaultyObjects::warn(QStringList& warnings, const QString& sentence) const {
    if (count > 0) {
        warnings.push_back(sentence.arg(count).arg(first));
    }
}

QString transparentMaterialWarning() {
    return Text::tr(
        "The model has a transparent material without a texture, which is shown opaque; "
        "give the material a texture with transparency");
}

QString hiddenObjectsWarning() {
    return Text::tr("Hidden objects: %1, first %2. They are imported, too, and dipped with the "
                    "others; delete them in a modelling program if they do not belong to the part");
}

QString unclearTextureSetWarning() {
    return Text::tr(
        "The model has several sets of texture coordinates, and its file does not say clearly "
        "which set its texture uses; if the texture is misplaced, delete the other sets in a "
        "modelling program");
}

} // namespace dipwright
