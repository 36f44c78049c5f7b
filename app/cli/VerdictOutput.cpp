#include "cli/VerdictOutput.h"

#include "pipeline/JobVerdict.h"

namespace dipwright::cli {

void printVerdict(const JobResult& result, QTextStream& out) {
    out << adviceText(adviceOf(result)).toUpper() << '\n';
    for (const JobReason& reason : reasonsOf(result)) {
        out << QStringLiteral("  %1\n").arg(reasonText(reason, result, millimetres));
    }
}

} // namespace dipwright::cli
