#include "import/sandboxed/ThreeDsCheck.h"

#include <QCoreApplication>
#include <QtEndian>

#include <algorithm>
#include <array>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::ImportModel)
};

enum Chunk : quint16 {
    Main = 0x4d4d,
    Editor = 0x3d3d,
    MasterScale = 0x0100,
    Object = 0x4000,
    Hidden = 0x4010,
    Mesh = 0x4100,
    Matrix = 0x4160,
};

constexpr qint64 longestName = 64; // of an object, in messages

class ThreeDsCheck {
public:
    explicit ThreeDsCheck(const QByteArray& file) : bytes_(file) { read(0, bytes_.size(), 0); }

    const QByteArray& bytes() const { return bytes_; }

    void warn(QStringList& warnings) const {
        if (masterScale_ != 0 && masterScale_ != 1) { // some files leave it 0
            warnings.push_back(
                Text::tr("The file has a master scale of %1, which programs apply in different "
                         "ways, so it is not applied; check the size of the model")
                    .arg(double(masterScale_)));
        }
        hidden_.warn(warnings, hiddenObjectsWarning());
        if (isMisfit_) {
            warnings.push_back(
                Text::tr("The sizes of the file's parts do not fit together, so its scale and its "
                         "mirrored objects are not known; export the model again"));
        }
        mirrored_.warn(
            warnings,
            Text::tr("Objects that their matrix mirrors: %1, first %2. Programs read these in "
                     "different ways, so they may be mirrored wrongly; apply their transforms in a "
                     "modelling program"));
    }

private:
    // Reads the chunks between two places: each has its kind, its size and its content.
    void read(qint64 begin, qint64 end, std::size_t depth) {
        constexpr std::array<Chunk, 4> path{Main, Editor, Object, Mesh};
        constexpr qint64 head = 6; // bytes
        for (qint64 next = 0; begin + head <= end; begin = next) {
            const auto kind = qFromLittleEndian<quint16>(bytes_.constData() + begin);
            const qint64 size = qFromLittleEndian<quint32>(bytes_.constData() + begin + 2);
            const qint64 content = begin + head;
            next = begin + size;
            if (size < head || next > end) {
                isMisfit_ = true;
                return;
            }
            if (depth < path.size() && kind == path[depth]) {
                read(kind == Object ? readName(content, next) : content, next, depth + 1);
            } else if (depth == 2 && kind == MasterScale && size >= head + 4) {
                masterScale_ = numberAt(content);
                qToLittleEndian(1.0F, bytes_.data() + content);
            } else if (depth == 3 && kind == Hidden) {
                hidden_.add(name_);
            } else if (depth == path.size() && kind == Matrix && size >= head + 48) {
                noteMatrix(content);
            }
        }
    }

    // Reads an object's name. Returns the place after it.
    qint64 readName(qint64 begin, qint64 end) {
        const qint64 zero = bytes_.indexOf('\0', begin);
        const qint64 last = zero < 0 ? end : std::min(zero, end);
        name_ = QString::fromLatin1(bytes_.mid(begin, std::min(last - begin, longestName)));
        return last + 1;
    }

    float numberAt(qint64 place) const {
        return qFromLittleEndian<float>(bytes_.constData() + place);
    }

    // Notes whether a matrix exchanges left and right. It begins with its three axes.
    void noteMatrix(qint64 place) {
        Eigen::Matrix3f axes;
        for (int entry = 0; entry < 9; ++entry) {
            axes(entry / 3, entry % 3) = numberAt(place + 4 * entry);
        }
        if (axes.determinant() < 0) {
            mirrored_.add(name_);
        }
    }

    QByteArray bytes_;
    float masterScale_ = 1;
    bool isMisfit_ = false; // a chunk does not fit into the one round it
    QString name_;
    FaultyObjects mirrored_, hidden_;
};

} // namespace

QByteArray threeDsForAssimp(const ModelSource& source, QStringList& warnings) {
    const ThreeDsCheck check(source.bytes);
    check.warn(warnings);
    return check.bytes();
}

} // namespace dipwright
