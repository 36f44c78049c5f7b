#include "model/ModelHash.h"

#include "base/Bytes.h"
#include "base/InkPicture.h"
#include "base/Sha256.h"
#include "model/StoredModel.h"
#include "settings/Artwork.h"

#include <mutex>

namespace dipwright {
namespace {

using Model = std::shared_ptr<const TexturedMesh>;

// The hash of the last model.
class RememberedHash {
public:
    explicit RememberedHash(void (*add)(Sha256&, const TexturedMesh&)) : add_(add) {}

    QString of(const Model& model) {
        const std::scoped_lock lock(mutex_);
        if (last_.lock() != model) {
            Sha256 hash;
            add_(hash, *model);
            hash_ = QString::fromLatin1(hash.result().toHex());
            last_ = model;
        }
        return hash_;
    }

private:
    void (*add_)(Sha256&, const TexturedMesh&);
    std::mutex mutex_;
    std::weak_ptr<const TexturedMesh> last_;
    QString hash_;
};

void addMesh(Sha256& hash, const TexturedMesh& model) {
    hash.add(bytesOf(model.mesh.positions));
    hash.add(bytesOf(model.mesh.triangles));
}

void addModel(Sha256& hash, const TexturedMesh& model) {
    hash.add(writeModel(withoutPictures(model)));
    for (const std::vector<QImage>* pictures : {&model.textures, &model.inks}) {
        for (const QImage& picture : *pictures) { // an amount of ink may be null
            hash.add((artworkPicture(picture).id + inkSpace(picture)).toLatin1());
        }
    }
}

} // namespace

QString meshHash(const Model& model) {
    static RememberedHash remembered(addMesh);
    return remembered.of(model);
}

QString modelHash(const Model& model) {
    static RememberedHash remembered(addModel);
    return remembered.of(model);
}

} // namespace dipwright
