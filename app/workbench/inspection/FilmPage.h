// The page that measures a film on the water: photos with their times, other inputs, and results.
#pragma once

#include "inspection/FilmWatch.h"

#include <QImage>
#include <QWidget>

#include <array>
#include <memory>

class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;
class QTabWidget;

namespace dipwright {

class NumberBox;
class PicturePanel;

// The measurement, with a picture of each photo and the boards found in it.
struct WatchedFilm {
    FilmWatch watch;
    std::vector<QImage> boards; // in the order of the watch's photos
};

class FilmPage : public QWidget {
    Q_OBJECT

public:
    explicit FilmPage(QWidget* parent = nullptr);

    // Shows the project's inputs. `profileBegin`: default start of the dip, seconds.
    void setFilm(const FilmOnWater& film, double profileBegin);
    // Shows the measurement; null: none, or the inputs have changed since.
    void setMeasured(std::shared_ptr<const WatchedFilm> measured);
    void setBusy(bool busy);

signals:
    void photosChosen(const QStringList& files);
    // `what`: the name of the changed field. Consecutive changes of the same field are one undo
    // step.
    void filmChanged(const FilmOnWater& film, const QString& what);
    void pagesAsked(); // the film and the card to print
    void measureAsked();
    void saveAsked();
    void exportAsked();

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    QWidget* makeFields();
    QWidget* makeRulers();
    QWidget* makePhotoButtons();
    QWidget* makeResultButtons();
    // Makes a field whose lowest value means "no value" and shows the text `none`.
    NumberBox* box(const char* name, double minimum, double maximum, double step,
                   const QString& suffix, const QString& none = {});
    void change(const QString& what);
    void removeChosen();
    void showPhotos();
    void showPicture();
    void enable();

    FilmOnWater film_;
    double profileBegin_ = 0;
    bool busy_ = false;
    bool shows_ = false; // while the page fills its fields
    std::shared_ptr<const WatchedFilm> measured_;
    QTableWidget* table_;
    NumberBox *begin_, *water_, *rulerError_, *cardAbove_, *focal_, *k1_, *k2_;
    std::array<NumberBox*, 2> cardRulers_, filmRulers_;
    QLineEdit* lot_;
    QPushButton *pages_, *remove_, *measure_, *save_, *export_;
    QLabel *words_, *photoWords_;
    QTabWidget* pictures_;
    PicturePanel *boards_, *map_;
};

} // namespace dipwright
