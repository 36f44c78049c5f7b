// Refuses a photo that is given twice. Its places would count twice, and a copy under another name
// would be measured as another view or another moment.
#pragma once

#include <QString>

#include <algorithm>

namespace dipwright {

// Throws Error, naming both files.
[[noreturn]] void refuseSamePhoto(const QString& photo, const QString& other);

// Throws Error if the content of `photo` is that of one of `others`. Both have `where` and
// `sha256`; a photo without a hash counts as different.
template <typename Photos, typename Photo>
void requireNewPhoto(const Photos& others, const Photo& photo) {
    const auto same = std::ranges::find(others, photo.sha256, &Photo::sha256);
    if (!photo.sha256.isEmpty() && same != std::ranges::end(others)) {
        refuseSamePhoto(photo.where, same->where);
    }
}

} // namespace dipwright
