#include "VtkConversions.h"

#include "base/WideGamut.h"

#include <algorithm>
#include <cstring>
#include <vtkImageData.h>

namespace dipwright {

vtkSmartPointer<vtkMatrix4x4> vtkMatrix(const Eigen::Isometry3d& transform) {
    auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            matrix->SetElement(row, column, transform.matrix()(row, column));
        }
    }
    return matrix;
}

vtkSmartPointer<vtkTexture> vtkTextureOf(const QImage& picture) {
    // Without alpha: VTK would draw a body as translucent if unused parts of its texture are clear.
    constexpr int bytes = 3;
    const QImage pixels = inSrgb(picture).convertToFormat(QImage::Format_RGB888);
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(pixels.width(), pixels.height(), 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, bytes);
    for (int row = 0; row < pixels.height(); ++row) {
        std::memcpy(image->GetScalarPointer(0, pixels.height() - 1 - row, 0),
                    pixels.constScanLine(row), std::size_t(pixels.width()) * bytes);
    }
    auto texture = vtkSmartPointer<vtkTexture>::New();
    texture->SetInputData(image);
    texture->InterpolateOn();
    texture->MipmapOn();
    texture->SetMaximumAnisotropicFiltering(4);
    return texture;
}

std::array<double, 3> vtkColour(const QColor& colour) {
    return {colour.redF(), colour.greenF(), colour.blueF()};
}

std::array<unsigned char, 3> vtkBytes(QRgb colour) {
    return {static_cast<unsigned char>(qRed(colour)), static_cast<unsigned char>(qGreen(colour)),
            static_cast<unsigned char>(qBlue(colour))};
}

} // namespace dipwright
