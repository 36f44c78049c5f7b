#include "python/Arrays.h"

namespace dipwright::python {
namespace {

bool isArray(QImage::Format format) {
    switch (format) {
    case QImage::Format_RGBA8888:
    case QImage::Format_RGBX8888:
    case QImage::Format_RGB888:
    case QImage::Format_RGBA64:
    case QImage::Format_RGBX64:
    case QImage::Format_Grayscale8:
    case QImage::Format_Grayscale16:
        return true;
    default:
        return false;
    }
}

int channelsOf(const QImage& picture) {
    const QImage::Format format = picture.format();
    const bool isGrey = format == QImage::Format_Grayscale8 || format == QImage::Format_Grayscale16;
    return isGrey ? 1 : format == QImage::Format_RGB888 ? 3 : 4;
}

} // namespace

py::array readOnly(py::array array) {
    py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    return array;
}

py::capsule capsuleOf(Owner owner) {
    auto kept = std::make_unique<Owner>(std::move(owner));
    return {kept.release(), [](void* pointer) { delete static_cast<Owner*>(pointer); }};
}

py::array pixels(const QImage& picture) {
    const auto kept = std::make_shared<const QImage>(
        isArray(picture.format()) ? picture : picture.convertToFormat(QImage::Format_RGBA8888));
    const int channels = channelsOf(*kept);
    const int bytes = kept->depth() / 8 / channels;
    Shape shape{kept->height(), kept->width()};
    Shape strides{py::ssize_t(kept->bytesPerLine()), channels * bytes};
    if (channels > 1) {
        shape.push_back(channels);
        strides.push_back(bytes);
    }
    const auto type = bytes == 1 ? py::dtype::of<std::uint8_t>() : py::dtype::of<std::uint16_t>();
    return readOnly(py::array(type, shape, strides, kept->constBits(), capsuleOf(kept)));
}

} // namespace dipwright::python
