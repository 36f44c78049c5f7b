#include "sheet/pdf/ImageObject.h"

#include <qpdf/Pipeline.hh>

namespace dipwright {

QPDFObjectHandle imageObject(QPDF& pdf, const PackedPixels& pixels, const QPDFObjectHandle& space) {
    const auto number = [](int value) { return QPDFObjectHandle::newInteger(value); };
    constexpr int pngFilters = 15; // ISO 32000-1, table 10
    QPDFObjectHandle filtered = QPDFObjectHandle::newDictionary();
    filtered.replaceKey("/Predictor", number(pngFilters));
    filtered.replaceKey("/Colors", number(pixels.channels));
    filtered.replaceKey("/BitsPerComponent", number(pixels.bits));
    filtered.replaceKey("/Columns", number(pixels.size.width()));
    QPDFObjectHandle stream = QPDFObjectHandle::newStream(&pdf);
    const auto write = [&pixels](Pipeline* output) {
        for (const QByteArray& part : pixels.parts) {
            output->write(reinterpret_cast<const unsigned char*>(part.constData()),
                          std::size_t(part.size()));
        }
        output->finish();
    };
    stream.replaceStreamData(write, QPDFObjectHandle::newName("/FlateDecode"), filtered);
    QPDFObjectHandle image = stream.getDict();
    image.replaceKey("/Type", QPDFObjectHandle::newName("/XObject"));
    image.replaceKey("/Subtype", QPDFObjectHandle::newName("/Image"));
    image.replaceKey("/Width", number(pixels.size.width()));
    image.replaceKey("/Height", number(pixels.size.height()));
    image.replaceKey("/BitsPerComponent", number(pixels.bits));
    image.replaceKey("/ColorSpace", space);
    return stream;
}

} // namespace dipwright
