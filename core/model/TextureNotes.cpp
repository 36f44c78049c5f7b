#include "model/TextureNotes.h"

#include "base/ColourNote.h"

#include <QCoreApplication>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::TexturedMesh)
};

} // namespace

QStringList colourNotes(const SurfaceAppearance& appearance) {
    QStringList notes;
    const std::size_t count = appearance.textures.size();
    for (std::size_t number = 0; number < count; ++number) {
        const QString name = count == 1 ? Text::tr("The model's texture")
                                        : Text::tr("Texture %1 of the model").arg(number + 1);
        notes << colourNoteText(appearance.textures[number], name);
    }
    notes.removeAll(QString());
    return notes;
}

} // namespace dipwright
