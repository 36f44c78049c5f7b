#include "import/sandboxed/FbxNodes.h"

#include <QtEndian>

#include <cctype>

namespace dipwright {

namespace {

// Values are separated by commas. Texts are in quotes.
FbxValues textValues(QByteArrayView rest, int count) {
    constexpr qsizetype longest = 10'000; // bytes
    FbxValues values{QByteArray()};
    bool isQuoted = false;
    for (const char byte : rest.first(std::min(rest.size(), longest))) {
        if (byte == '\n' || (!isQuoted && byte == '{')) {
            break;
        }
        isQuoted ^= byte == '"';
        if (byte == ',' && !isQuoted) {
            if (values.size() == count) {
                break;
            }
            values.push_back(QByteArray());
        } else if (byte != '"' && (isQuoted || std::isspace(uchar(byte)) == 0)) {
            values.back() += byte;
        }
    }
    return values;
}

// Returns the bytes of a binary value after its type; 0 for another type.
qsizetype sizeOf(char type, QByteArrayView after) {
    constexpr qsizetype head = 4; // bytes of a text's length
    switch (type) {
    case 'S':
        return after.size() < head ? 0 : head + qFromLittleEndian<quint32>(after.data());
    case 'L':
    case 'D':
        return 8;
    case 'I':
    case 'F':
        return 4;
    default:
        return 0;
    }
}

// Each value follows a letter for its type.
FbxValues binaryValues(QByteArrayView rest, int count) {
    FbxValues values;
    while (values.size() < count && rest.size() > 1) {
        const char type = rest[0];
        const char* const begin = rest.data() + 1;
        const qsizetype size = sizeOf(type, rest.sliced(1));
        if (size == 0 || size >= rest.size()) {
            break;
        }
        values.push_back(type == 'S'   ? QByteArray(begin + 4, size - 4)
                         : type == 'L' ? QByteArray::number(qFromLittleEndian<qint64>(begin))
                         : type == 'I' ? QByteArray::number(qFromLittleEndian<qint32>(begin))
                         : type == 'D'
                             ? QByteArray::number(qFromLittleEndian<double>(begin))
                             : QByteArray::number(double(qFromLittleEndian<float>(begin))));
        rest = rest.sliced(1 + size);
    }
    return values;
}

} // namespace

QByteArray FbxNodes::keyOf(const QByteArray& name) const {
    return isBinary_ ? char(name.size()) + name : name + ':';
}

bool FbxNodes::mayBeginAt(qsizetype place) const {
    return isBinary_ || place == 0 || std::isspace(uchar(bytes_[place - 1])) != 0;
}

FbxValues FbxNodes::valuesAt(qsizetype place, int count) const {
    const QByteArrayView after = bytes_.sliced(place);
    return isBinary_ ? binaryValues(after, count) : textValues(after, count);
}

} // namespace dipwright
