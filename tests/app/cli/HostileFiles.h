// Writes malicious files, one of each kind that once did harm or was made to do harm.
#pragma once

#include <QString>

namespace dipwright::test {

void writeHostileFiles(const QString& folder);

} // namespace dipwright::test
