// The translations are complete, keep their places for values, and stand for the texts of today.
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

namespace {

struct Message {
    QString context, source;
    QStringList translations; // one a plural form
    bool finished = true;
};

QList<Message> readMessages(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return {};
    }
    QList<Message> messages;
    QString context;
    QXmlStreamReader xml(&file);
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) {
            continue;
        }
        if (xml.name() == QLatin1String("name")) {
            context = xml.readElementText();
        } else if (xml.name() == QLatin1String("message")) {
            messages.append({.context = context, .source = {}, .translations = {}});
        } else if (xml.name() == QLatin1String("source")) {
            messages.last().source = xml.readElementText();
        } else if (xml.name() == QLatin1String("translation")) {
            messages.last().finished = !xml.attributes().hasAttribute(QStringLiteral("type"));
            const QString text = xml.readElementText(QXmlStreamReader::IncludeChildElements);
            messages.last().translations.append(text);
        }
    }
    return messages;
}

QSet<QString> places(const QString& text) {
    static const QRegularExpression place(QStringLiteral("%(L?\\d+|n)"));
    QSet<QString> found;
    for (const auto& match : place.globalMatch(text)) {
        found.insert(match.captured());
    }
    return found;
}

} // namespace

class TranslationTest : public QObject {
    Q_OBJECT

private slots:
    void everyTextIsTranslated_data() { addLanguages(); }
    void everyTextIsTranslated() {
        QFETCH(QString, file);
        const QList<Message> messages = readMessages(file);
        QVERIFY(messages.size() > 500);
        for (const Message& message : messages) {
            QVERIFY2(message.finished && !message.translations.value(0).isEmpty(),
                     qPrintable(message.context + QStringLiteral(": ") + message.source));
        }
    }

    void valuesKeepTheirPlaces_data() { addLanguages(); }
    void valuesKeepTheirPlaces() {
        QFETCH(QString, file);
        for (const Message& message : readMessages(file)) {
            for (const QString& translation : message.translations) {
                QVERIFY2(places(translation) == places(message.source), qPrintable(message.source));
            }
        }
    }

    void theGuideHasTheSameChaptersInEveryLanguage() {
        const int chapters = chaptersOf(QStringLiteral("guide.md"));
        QVERIFY(chapters > 5);
        QCOMPARE(chaptersOf(QStringLiteral("guide.de.md")), chapters);
        QCOMPARE(chaptersOf(QStringLiteral("guide.pt_BR.md")), chapters);
    }

    // Reads the workbench's sources anew: a text that was changed needs its translation again.
    void theWorkbenchHasNoTextThatIsNotListed() {
        const QTemporaryDir folder;
        const QString fresh = folder.filePath(QStringLiteral("fresh.ts"));
        QProcess lupdate;
        lupdate.start(QStringLiteral(DIPWRIGHT_LUPDATE),
                      {QStringLiteral("-silent"), QStringLiteral("-extensions"),
                       QStringLiteral("cpp,h"), QStringLiteral(DIPWRIGHT_SOURCES "/app"),
                       QStringLiteral("-ts"), fresh});
        QVERIFY(lupdate.waitForFinished(60'000));
        QSet<QString> listed;
        for (const Message& message :
             readMessages(QStringLiteral(DIPWRIGHT_SOURCES "/translations/dipwright_de.ts"))) {
            listed.insert(message.context + message.source);
        }
        const QList<Message> current = readMessages(fresh);
        QVERIFY(!current.isEmpty());
        for (const Message& message : current) {
            QVERIFY2(listed.contains(message.context + message.source),
                     qPrintable(message.context + QStringLiteral(": ") + message.source));
        }
    }

    void everyNameThatComesInAFileIsListed() {
        const QString sources = QStringLiteral(DIPWRIGHT_SOURCES);
        QStringList files;
        for (const QString& folder :
             {QStringLiteral("/resources/profiles"), QStringLiteral("/plugins")}) {
            QDirIterator every(sources + folder,
                               {QStringLiteral("*.json"), QStringLiteral("*.json.in")}, QDir::Files,
                               QDirIterator::Subdirectories);
            while (every.hasNext()) {
                files += every.next();
            }
        }
        QVERIFY(files.size() > 8);
        QSet<QString> listed;
        for (const Message& message :
             readMessages(sources + QStringLiteral("/translations/dipwright_de.ts"))) {
            if (message.context == QLatin1String("ShippedNames")) {
                listed.insert(message.source);
            }
        }
        static const QRegularExpression nameLine(QStringLiteral("\"name\": \"([^\"]+)\""));
        for (const QString& path : files) {
            QFile file(path);
            QVERIFY(file.open(QIODevice::ReadOnly));
            const QString name = nameLine.match(QString::fromUtf8(file.readAll())).captured(1);
            QVERIFY2(listed.contains(name), qPrintable(path));
        }
    }

private:
    static int chaptersOf(const QString& guide) {
        QFile file(QStringLiteral(DIPWRIGHT_SOURCES "/resources/guide/") + guide);
        return file.open(QIODevice::ReadOnly) ? int(file.readAll().count("\n## ")) : 0;
    }
    void addLanguages() {
        QTest::addColumn<QString>("file");
        const QDir folder(QStringLiteral(DIPWRIGHT_SOURCES "/translations"));
        for (const QString& name : folder.entryList({QStringLiteral("*.ts")})) {
            QTest::newRow(qPrintable(name)) << folder.filePath(name);
        }
    }
};

QTEST_GUILESS_MAIN(TranslationTest)
#include "TranslationTest.moc"
