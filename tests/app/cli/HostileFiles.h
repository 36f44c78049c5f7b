// Writes malicious files: one of each kind that once did harm or was designed to do harm.
#pragma once

#include <QString>

namespace dipwright::test {

void writeHostileFiles(const QString& folder);

} // namespace dipwright::test
