// Draws the guide's pictures of measuring a film, in the user's language.
#pragma once

#include <QImage>
#include <QStringList>

namespace dipwright {

// Returns the picture names in the guide: "tank-pages", "tank-water", "tank-photos".
QStringList guidePictures();
// Draws one picture, `width` pixels wide.
QImage guidePicture(const QString& name, int width);

} // namespace dipwright
