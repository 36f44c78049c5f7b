#include "import/trusted/UntrustedFiles.h"

#include "base/Budgets.h"

namespace dipwright {

std::optional<QByteArray> UntrustedFiles::read(const QString& name) {
    requireWithin(Budget::NamedFiles, ++filesAskedFor_, name);
    std::optional<QByteArray> bytes = fetch(name);
    bytesRead_ += bytes ? bytes->size() : 0;
    return bytes;
}

} // namespace dipwright
