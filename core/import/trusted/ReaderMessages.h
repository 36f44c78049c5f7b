// Defines the messages between this program and dipwright-reader, which reads untrusted files.
//   to the reader:   one job, then an answer to each file request
//   from the reader: file requests, progress, and at the end either the result or a failure
// A message consists of its kind (u8), the length of its data (u64, little-endian) and its data.
#pragma once

#include "import/trusted/CadFacts.h"

#include <QByteArray>
#include <QImage>
#include <QStringList>

namespace dipwright {

enum class ReaderMessage : quint8 {
    Job = 1,  // ReaderJob
    File,     // content of the requested file
    NoFile,   // the file does not exist or may not be read
    Ask,      // request for a file: its name, UTF-8
    Progress, // share (double), text
    Photo,    // metadata of a photo (PhotoFacts); a Picture message with the photo follows
    // Data of a picture, each an i32: width, height, dots per metre in both directions, whether it
    // is wide, and whether its colour note says that inks were assumed. Then the note's clipped
    // share (double), the ink space (16 bytes, 0 for colours) and the rows of pixels without gaps.
    Picture,
    Inks,  // the amounts of ink (base/InkPicture.h) of the next Picture; data as of a Picture
    Cad,   // facts about a CAD model; a Model message follows
    Model, // warnings; a Mesh message follows
    Mesh,  // a mesh in the format of StoredModel
    Failed // message and place of an Error
};

constexpr qint64 readerHeaderBytes = 9;

struct ReaderJob {
    enum class Kind : quint8 { Model, Pictures, Photos };
    Kind kind = Kind::Model;
    QStringList names;              // name of the model file, or of each picture
    bool withTextures = true;       // whether to read a model's textures
    QString language;               // language of messages, such as "de"; empty is English
    Tessellation tessellation = {}; // of a CAD model
};

// Data that a camera writes into a photo (EXIF 2.3).
struct PhotoFacts {
    // By the camera's clock, such as "2026:11:22 14:03:07"; empty if unknown.
    QString taken;
    double focalLength = 0; // 35 mm equivalent (36 × 24 mm), mm; 0 if unknown
};

// Exit code of the reader when it runs out of time and cannot send a message.
constexpr int readerOutOfTime = 3;

QByteArray headerBytes(ReaderMessage kind, qint64 length);
// Returns kind and length as sent. Neither can be trusted.
std::pair<ReaderMessage, qint64> readHeader(const QByteArray& header);

QByteArray jobBytes(const ReaderJob& job);
ReaderJob readJob(const QByteArray& bytes);

QByteArray factsBytes(const PhotoFacts& facts);
PhotoFacts readFacts(const QByteArray& bytes);

QByteArray cadBytes(const CadFacts& facts);
CadFacts readCadFacts(const QByteArray& bytes);

// Returns the part of a picture's message before its pixels.
QByteArray pictureHeaderBytes(const QImage& picture);
constexpr qint64 pictureHeaderLength = 56;
// Returns an empty picture of the size in `header`; null if the size is invalid or memory is
// insufficient. Does not throw.
QImage emptyPicture(const QByteArray& header);

} // namespace dipwright
