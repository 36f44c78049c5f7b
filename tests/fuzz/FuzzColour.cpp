// Fuzzes the reader of a printer's ICC profile.
#include "base/Error.h"
#include "sheet/prepress/PrinterColour.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    const QByteArray bytes(reinterpret_cast<const char*>(data), qsizetype(size));
    QImage picture(4, 4, QImage::Format_RGB888);
    picture.fill(Qt::red);
    try {
        const dipwright::PrinterColour colour(bytes, dipwright::RenderingIntent::Perceptual, true,
                                              QStringLiteral("x"));
        colour.softProof(picture);
    } catch (const dipwright::Error&) {
    }
    return 0;
}
