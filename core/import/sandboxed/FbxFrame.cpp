#include "import/sandboxed/FbxFrame.h"

#include <QCoreApplication>

#include <assimp/scene.h>

#include <cmath>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::ImportModel)
};

void refuse(const ModelSource& source) {
    source.throwDamaged(Text::tr("its GlobalSettings name impossible axes or units"));
}

template <typename Number>
Number setting(const aiScene& scene, const std::string& name, Number usual) {
    Number value = usual;
    return scene.mMetaData && scene.mMetaData->Get(name, value) ? value : usual;
}

// Returns the direction of an axis in the file's coordinates; zero if the file names none.
Eigen::RowVector3f axis(const aiScene& scene, const std::string& name, int usual) {
    const int index = setting(scene, name, usual);
    const int sign = setting(scene, name + "Sign", 1);
    Eigen::RowVector3f direction = Eigen::RowVector3f::Zero();
    if (index >= 0 && index < 3) {
        direction[index] = sign < 0 ? -1 : 1;
    }
    return direction;
}

} // namespace

Eigen::Matrix3f fbxFrame(const aiScene& scene, const ModelSource& source) {
    constexpr float centimetre = 10; // mm
    // The type depends on assimp's version.
    const double unit = setting<double>(scene, "UnitScaleFactor",
                                        double(setting<float>(scene, "UnitScaleFactor", 1)));
    Eigen::Matrix3f frame;
    frame << axis(scene, "CoordAxis", 0), axis(scene, "UpAxis", 1), axis(scene, "FrontAxis", 2);
    if (std::abs(frame.determinant()) != 1 || !std::isfinite(unit) || unit <= 0) {
        refuse(source);
    }
    return float(unit) * centimetre * frame;
}

} // namespace dipwright
