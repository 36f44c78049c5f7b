#include "workbench/appearance/ViewTheme.h"

namespace dipwright {

ViewColours viewColours(bool dark) {
    if (dark) {
        return {QColor(0x3a4048), QColor(0x1c1f24), QColor(0xc8ced6), QColor(0xffa94d),
                QColor(0x3d7fb8)};
    }
    return {QColor(0xdfe7ee), QColor(0xf8fafb), QColor(0x3c4650), QColor(0xd9480f),
            QColor(0x4f9bd6)};
}

} // namespace dipwright
