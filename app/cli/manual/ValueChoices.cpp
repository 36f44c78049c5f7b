#include "cli/manual/ValueChoices.h"

#include <QRegularExpression>

namespace dipwright::cli {

ValueChoices choicesOf(const QString& valueName) {
    static const QRegularExpression word(QStringLiteral("^[a-z0-9-]+$"));
    ValueChoices choices;
    for (const QString& alternative : valueName.split(QLatin1Char('|'), Qt::SkipEmptyParts)) {
        for (const QString& part : alternative.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
            if (part.endsWith(QLatin1String(".dipw"))) {
                choices.projects = true;
            } else if (part.startsWith(QLatin1String("FILE"))) {
                choices.files = true;
            } else if (part == QLatin1String("DIR")) {
                choices.folders = true;
            } else if (word.match(part).hasMatch()) {
                choices.words << part;
            }
        }
    }
    return choices;
}

} // namespace dipwright::cli
