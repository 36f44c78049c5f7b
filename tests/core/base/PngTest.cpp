// PNG files: Qt's own reader returns the picture that was written.
#include "base/Png.h"

#include "base/Error.h"
#include "base/WideGamut.h"
#include "parallel/Threads.h"

#include <QBuffer>
#include <QColorSpace>
#include <QtTest>

using namespace dipwright;

namespace {

// Noise beside a gradient, so that every kind of neighbourhood occurs.
QImage picture(QSize size, QImage::Format format) {
    QImage image(size, QImage::Format_RGBA8888);
    quint32 random = 1;
    for (int y = 0; y < size.height(); ++y) {
        for (int x = 0; x < size.width(); ++x) {
            random = random * 1664525 + 1013904223;
            const bool isNoise = x < size.width() / 3;
            image.setPixelColor(x, y,
                                isNoise ? QColor::fromRgba(random)
                                        : QColor(x % 256, y % 256, (x + y) % 256, 255 - x % 256));
        }
    }
    return image.convertToFormat(format);
}

QImage stored(const QImage& image) {
    return QImage::fromData(pngBytes(image, QStringLiteral("picture")), "PNG");
}

} // namespace

class PngTest : public QObject {
    Q_OBJECT
private slots:
    void pngBytes_readByQt_givesTheSamePixels_data() {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<QImage::Format>("format");
        QTest::newRow("a pixel") << QSize(1, 1) << QImage::Format_RGB888;
        QTest::newRow("a row") << QSize(70, 1) << QImage::Format_RGBA8888;
        QTest::newRow("several bands") << QSize(1501, 1203) << QImage::Format_RGB888;
        QTest::newRow("several bands, with alpha") << QSize(1203, 1501) << QImage::Format_RGBA8888;
        QTest::newRow("rows longer than a band") << QSize(400'000, 3) << QImage::Format_RGB888;
        QTest::newRow("premultiplied alpha")
            << QSize(90, 70) << QImage::Format_ARGB32_Premultiplied;
        QTest::newRow("grey") << QSize(91, 70) << QImage::Format_Grayscale8;
    }
    void pngBytes_readByQt_givesTheSamePixels() {
        QFETCH(QSize, size);
        QFETCH(QImage::Format, format);
        const QImage image = picture(size, format);
        const QImage again = stored(image);
        const auto plain =
            image.hasAlphaChannel() ? QImage::Format_RGBA8888 : QImage::Format_RGB888;
        QVERIFY(again.convertToFormat(plain) == image.convertToFormat(plain));
        QCOMPARE(again.hasAlphaChannel(), image.hasAlphaChannel());
    }

    void pngBytes_keepsResolutionAndColourSpace() {
        QImage image = picture({40, 30}, QImage::Format_RGB888);
        image.setDotsPerMeterX(11811);
        image.setDotsPerMeterY(5906);
        image.setColorSpace(QColorSpace::AdobeRgb);
        const QImage again = stored(image);
        QCOMPARE(again.dotsPerMeterX(), 11811);
        QCOMPARE(again.dotsPerMeterY(), 5906);
        QCOMPARE(again.colorSpace(), QColorSpace(QColorSpace::AdobeRgb));
        image.setColorSpace(QColorSpace());
        QVERIFY(!stored(image).colorSpace().isValid());
    }

    void pngBytes_wideColour_keeps16Bits() {
        QImage image = inWide(picture({300, 200}, QImage::Format_RGBA8888));
        image.setPixelColor(3, 4, QColor::fromRgba64(12345, 54321, 257, 40000));
        const QImage again = stored(image);
        QCOMPARE(again.format(), QImage::Format_RGBA64);
        QVERIFY(again == image);
        QCOMPARE(again.colorSpace().iccProfile(), wideSpace().iccProfile());
    }

    void pngBytes_anyNumberOfThreads_givesTheSameBytes() {
        const QImage image = picture({1501, 1203}, QImage::Format_RGB888);
        const QByteArray onAll = pngBytes(image, QString());
        const ThreadLimit limit(1);
        QVERIFY(pngBytes(image, QString()) == onAll);
    }

    void writePng_emptyPictureOrReadOnlyDevice_isRefused() {
        const QString where = QStringLiteral("sheet.png");
        QVERIFY_EXCEPTION_THROWN(pngBytes(QImage(), where), Error);
        QByteArray bytes;
        QBuffer readOnly(&bytes);
        readOnly.open(QIODevice::ReadOnly);
        QTest::ignoreMessage(QtWarningMsg, "QIODevice::write (QBuffer): ReadOnly device");
        QVERIFY_EXCEPTION_THROWN(writePng(picture({4, 4}, QImage::Format_RGB888), readOnly, where),
                                 Error);
    }
};

QTEST_APPLESS_MAIN(PngTest)
#include "PngTest.moc"
