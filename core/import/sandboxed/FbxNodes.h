// Reads nodes of an FBX file, which is text or binary. Private to this folder.
#pragma once

#include <QByteArray>
#include <QList>

#include <algorithm>

namespace dipwright {

// Values of a node: texts without quotes, and numbers as texts.
using FbxValues = QList<QByteArray>;

// All or some nodes of an FBX file 7. The file must outlive it. Finds nodes by their names only, so
// it may also find such bytes within arrays; check the values.
class FbxNodes {
public:
    explicit FbxNodes(const QByteArray& file)
        : FbxNodes(file, file.startsWith("Kaydara FBX Binary")) {}

    // Calls `use` with the first values of each node of this name, at most `count`, and with the
    // place after its name.
    template <typename Use>
    void forEach(const QByteArray& name, int count, const Use& use) const {
        const QByteArray key = keyOf(name);
        for (qsizetype at = bytes_.indexOf(key); at >= 0; at = bytes_.indexOf(key, at)) {
            const bool isNode = mayBeginAt(at);
            at += key.size();
            if (isNode) {
                use(valuesAt(at, count), at);
            }
        }
    }

    QByteArrayView bytes() const { return bytes_; }
    // Returns the nodes from a place on, or all if it is negative.
    FbxNodes from(qsizetype begin) const { return part(std::max<qsizetype>(begin, 0), size()); }
    FbxNodes part(qsizetype begin, qsizetype end) const {
        return FbxNodes(bytes_.sliced(begin, std::min(end, size()) - begin), isBinary_);
    }

private:
    FbxNodes(QByteArrayView bytes, bool isBinary) : bytes_(bytes), isBinary_(isBinary) {}
    qsizetype size() const { return bytes_.size(); }
    QByteArray keyOf(const QByteArray& name) const;
    bool mayBeginAt(qsizetype place) const;
    FbxValues valuesAt(qsizetype place, int count) const;

    QByteArrayView bytes_;
    bool isBinary_;
};

} // namespace dipwright
