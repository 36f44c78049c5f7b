// Numbers as users type them: calculations, units, decimal signs and digit groups.
#include "base/TypedNumber.h"

#include <QtTest>

using namespace dipwright;
using Fault = TypedNumber::Fault;
Q_DECLARE_METATYPE(TypedNumber::Fault)

class TypedNumberTest : public QObject {
    Q_OBJECT

private slots:
    void typedNumber_calculation_isInFieldsUnit_data() {
        QTest::addColumn<QString>("unit");
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("value");
        const auto row = [](const char* unit, const char* text, double value) {
            QTest::addRow("%s in %s", text, unit)
                << QString::fromUtf8(unit) << QString::fromUtf8(text) << value;
        };
        row("mm", "3*12", 36);
        row("mm", "1/3", 1.0 / 3);
        row("mm", "1 + 2 * 3 - 4/2", 5);
        row("mm", "-(2 − 5) × 4", 12);
        row("mm", "8/4/2", 1);
        row("mm", "1.5e3 - 2E-1*5", 1499);
        row("mm", "2in", 50.8);
        row("mm", "2 cm", 20);
        row("mm", "1/2in", 12.7);
        row("mm", "3/8\"", 9.525);
        row("mm", "2 * 1/4 in", 12.7);
        row("mm", "2in + 3", 53.8); // the 3 is in mm
        row("mm", "(2 + 3mm) * 2", 10);
        row("mm", "1ft - 2in", 254);
        row("mm", "30 mm/s * 2 s", 60);
        row("mm", "10 mm * 90° / 45°", 20);
        row("in", "25.4 mm", 1);
        row("in", "3 ft", 36);
        row("mm/s", "6 cm/min", 1);
        row("mm/s", "100 mm / 2 s", 50);
        row("in/s", "1 ft/min", 0.2);
        row("mm/s²", "1 m/s²", 1000);
        row("mm/s²", "1 cm/s/s", 10);
        row("s", "1.5min", 90);
        row("s", "250 ms", 0.25);
        row("°", "90°", 90);
        row("°", "45deg", 45);
        row("°", "0.5turn", 180);
        row("°", "0.25 turn + 5", 95);
        row("°/s", "2 rpm", 12);
        row("°/s", "1 turn/min", 6);
        row("%", "50%", 50);
        row("%", "1/4", 0.25);
        row("%/s", "60 %/min", 1);
        row("1/s", "0.6/min", 0.01);
        row("1/s", "0.02", 0.02);
        row("dpi", "300", 300);
        row("dpi", "12/mm", 12 * 25.4);
        row("×", "1.2 × 2 ×", 2.4);
        row("cells", "2*12 cells", 24);
        row("°C", "18 + 2.5 °C", 20.5);
        row("", "2 * (3 + 4)", 14);
    }
    void typedNumber_calculation_isInFieldsUnit() {
        QFETCH(QString, unit);
        QFETCH(QString, text);
        QFETCH(double, value);
        const TypedNumber typed = typedNumber(text, unit, QLocale(QLocale::English));
        QCOMPARE(int(typed.fault), int(Fault::None));
        QCOMPARE(typed.values.size(), std::size_t(1));
        QVERIFY2(std::abs(typed.values[0] - value) < 1e-9,
                 qPrintable(QString::number(typed.values[0], 'g', 12)));
    }

    void typedNumber_rad_isAngle() {
        const TypedNumber typed =
            typedNumber(QStringLiteral("2rad"), QStringLiteral("°"), QLocale::c());
        QVERIFY(std::abs(typed.values.at(0) - 114.59155902616465) < 1e-9);
    }

    void typedNumber_decimalComma_isReadInCalculations() {
        for (const QLocale::Language language : {QLocale::German, QLocale::Portuguese}) {
            const QLocale locale(language);
            const auto value = [&locale](const char* text) {
                return typedNumber(QString::fromUtf8(text), QStringLiteral("mm"), locale).values;
            };
            QCOMPARE(value("2,5*2"), std::vector<double>{5});
            QCOMPARE(value("1,5 cm + 0,5"), std::vector<double>{15.5});
            QCOMPARE(value("1.234,5 - 1"), std::vector<double>{1233.5});
        }
    }

    void typedNumber_ambiguousSign_hasBothReadings() {
        const TypedNumber typed =
            typedNumber(QStringLiteral("2*1,234"), QStringLiteral("mm"), QLocale(QLocale::English));
        QCOMPARE(typed.values, (std::vector<double>{2.468, 2468}));
    }

    void typedNumber_fault_isNamed_data() {
        QTest::addColumn<QString>("unit");
        QTest::addColumn<QString>("text");
        QTest::addColumn<Fault>("fault");
        const auto row = [](const char* unit, const char* text, Fault fault) {
            QTest::addRow("“%s” in %s", text, unit)
                << QString::fromUtf8(unit) << QString::fromUtf8(text) << fault;
        };
        row("mm", "2 s", Fault::OtherQuantity);
        row("mm", "0 s", Fault::OtherQuantity);
        row("mm", "2in * 3in", Fault::OtherQuantity);
        row("mm", "2 mm + 3 s", Fault::OtherQuantity);
        row("mm", "10%", Fault::OtherQuantity);
        row("mm/s", "5 mm", Fault::OtherQuantity);
        row("", "5 mm", Fault::OtherQuantity);
        row("mm", "2 furlongs", Fault::UnknownUnit);
        row("mm", "3 cells", Fault::UnknownUnit);
        row("mm", "1/0", Fault::NotANumber);
        row("mm", "1e400", Fault::TooLarge);
        row("mm", "2*", Fault::NotANumber);
        row("mm", "(2", Fault::NotANumber);
        row("mm", "2)", Fault::NotANumber);
        row("mm", "2 3", Fault::NotANumber);
        row("mm", "mm", Fault::NotANumber);
        row("mm", "--", Fault::NotANumber);
        row("mm", "", Fault::NotANumber);
    }
    void typedNumber_fault_isNamed() {
        QFETCH(QString, unit);
        QFETCH(QString, text);
        QFETCH(Fault, fault);
        const TypedNumber typed = typedNumber(text, unit, QLocale(QLocale::English));
        QCOMPARE(int(typed.fault), int(fault));
        QVERIFY(typed.values.empty());
    }

    void typedNumber_veryLongText_isRefused() {
        const QString brackets(1'000'000, u'(');
        QVERIFY(typedNumber(brackets, {}, QLocale::c()).values.empty());
    }
};

QTEST_GUILESS_MAIN(TypedNumberTest)
#include "TypedNumberTest.moc"
