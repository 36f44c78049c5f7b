#include "cli/PlainOutput.h"

#include "base/Bytes.h"

namespace dipwright::cli {
namespace {

// Removes control characters from UTF-8 text, including C2 80 to C2 9F.
QByteArray plain(const QByteArray& text) {
    QByteArray kept;
    kept.reserve(text.size());
    for (qsizetype at = 0; at < text.size(); ++at) {
        const auto byte = uchar(text[at]);
        const auto next = uchar(at + 1 < text.size() ? text[at + 1] : 0);
        const bool isLayout = byte == '\n' || byte == '\r' || byte == '\t';
        if (byte == 0xc2 && next >= 0x80 && next <= 0x9f) {
            ++at;
        } else if (isLayout || (byte >= 0x20 && byte != 0x7f)) {
            kept += text[at];
        }
    }
    return kept;
}

} // namespace

PlainOutput::PlainOutput(std::FILE* file) {
    file_.open(file, QIODevice::WriteOnly);
    open(QIODevice::WriteOnly | QIODevice::Unbuffered);
}

qint64 PlainOutput::readData(char*, qint64) {
    return -1;
}

qint64 PlainOutput::writeData(const char* bytes, qint64 size) {
    return writeAll(file_, plain(QByteArray(bytes, qsizetype(size)))) ? size : -1;
}

} // namespace dipwright::cli
