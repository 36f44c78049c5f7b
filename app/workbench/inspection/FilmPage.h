// The page of a film on the water: its photos with their times, what was told besides, and what
// they say.
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

// What was measured, with a picture of each photo and the boards found in it.
struct WatchedFilm {
    FilmWatch watch;
    std::vector<QImage> boards; // in the order of the watch's photos
};

class FilmPage : public QWidget {
    Q_OBJECT

public:
    explicit FilmPage(QWidget* parent = nullptr);

    // What the project has. `profileBegin`: when the dip begins where it does not say, seconds.
    void setFilm(const FilmOnWater& film, double profileBegin);
    // Null: nothing was measured, or something has changed since.
    void setMeasured(std::shared_ptr<const WatchedFilm> measured);
    void setBusy(bool busy);

signals:
    void photosChosen(const QStringList& files);
    // `what` was changed names the field, for changes of one field in a row to be one step.
    void filmChanged(const FilmOnWater& film, const QString& what);
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
    // A field that is emptied by its lowest value, which `none` says in words.
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
    bool shows_ = false; // fields are being set, not edited
    std::shared_ptr<const WatchedFilm> measured_;
    QTableWidget* table_;
    NumberBox *begin_, *water_, *rulerError_, *cardAbove_, *focal_, *k1_, *k2_;
    std::array<NumberBox*, 2> cardRulers_, filmRulers_;
    QLineEdit* lot_;
    QPushButton *remove_, *measure_, *save_, *export_;
    QLabel *words_, *photoWords_;
    QTabWidget* pictures_;
    PicturePanel *boards_, *map_;
};

} // namespace dipwright
