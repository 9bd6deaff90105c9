// SPDX-License-Identifier: BSD-3-Clause
#include <pendular/io/collection.hpp>

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "scratch.hpp"

namespace io = pendular::io;

namespace {

using listing = std::vector<std::pair<std::string, std::string>>;

/// Timestep and file of every DataSet, as they stand in the file.
listing listed(const std::filesystem::path& path) {
  const std::string text = scratch::content(path);
  listing frames;
  const auto after = [&](const std::string& words, std::size_t& at) {
    at = text.find(words, at) + words.size();
    return text.substr(at, text.find('"', at) - at);
  };
  for (std::size_t at = 0; (at = text.find("<DataSet", at)) != std::string::npos;) {
    const std::string time = after("timestep=\"", at);
    frames.emplace_back(time, after("file=\"", at));
  }
  return frames;
}

/// A run whose frame k, of the time k/4 s, is "<name><k>.vtp".
void write_frames(io::collection& series, const scratch::folder& folder, char name, int first, int last) {
  for (int k = first; k <= last; ++k) series.add(0.25 * k, folder / (name + std::to_string(k) + ".vtp"));
}

const listing killed_and_resumed{{"0", "a0.vtp"},    {"0.25", "a1.vtp"}, {"0.5", "b2.vtp"},
                                 {"0.75", "b3.vtp"}, {"1", "b4.vtp"},    {"1.25", "b5.vtp"}};

}  // namespace

TEST_CASE("a collection names its frames relative to itself after each frame", "[io][vtk]") {
  const scratch::folder folder;
  io::collection series{folder / "run.pvd", {{0, folder / "frames/0 & 1.vtp"}}};
  series.add(0.1, folder / "frames/1.vtp");
  CHECK(scratch::mentions(scratch::content(folder / "run.pvd"), {"timestep=\"0\"", "file=\"frames/0 &amp; 1.vtp\"",
                                                                 "timestep=\"0.1\" group=\"\" part=\"0\" "
                                                                 "file=\"frames/1.vtp\"",
                                                                 "</Collection>"}));
  series.add(0.2, folder / "2.vtp");
  CHECK(scratch::mentions(scratch::content(folder / "run.pvd"), {"frames/1.vtp", "\"0.2\"", "\"2.vtp\""}));
  CHECK(series.entries().size() == 3);
  CHECK(folder.files() == 1);
}

TEST_CASE("a resumed run keeps the frames before it and writes later ones anew", "[io][collection]") {
  const scratch::folder folder;
  const auto path = folder / "run.pvd";
  {
    io::collection first(path);
    write_frames(first, folder, 'a', 0, 3);
  }
  io::collection again(path);
  CHECK(again.entries().size() == 4);
  CHECK(listed(path).size() == 4);  // nothing is lost before the first frame is there
  write_frames(again, folder, 'b', 2, 5);
  CHECK(listed(path) == killed_and_resumed);
  CHECK(again.entries().size() == 6);
}

TEST_CASE("a resumed run whose frames are at other times drops all that are not before the first", "[io][collection]") {
  const scratch::folder folder;
  io::collection first(folder / "run.pvd");
  write_frames(first, folder, 'a', 0, 3);
  io::collection again(folder / "run.pvd");
  again.add(0.4, folder / "b.vtp");
  CHECK(listed(folder / "run.pvd") == listing{{"0", "a0.vtp"}, {"0.25", "a1.vtp"}, {"0.4", "b.vtp"}});
}

TEST_CASE("entries that are handed over are frames of before, whichever the caller kept", "[io][collection]") {
  const scratch::folder folder;
  const auto resumed = [&](int kept) {
    std::vector<io::collection::entry> entries;
    for (int k = kept - 1; k >= 0; --k) entries.push_back({0.25 * k, folder / ("a" + std::to_string(k) + ".vtp")});
    io::collection series(folder / "run.pvd", entries);
    write_frames(series, folder, 'b', 2, 5);
    return listed(folder / "run.pvd");
  };
  CHECK(resumed(2) == killed_and_resumed);
  CHECK(resumed(4) == killed_and_resumed);
  io::collection anew(folder / "run.pvd", {});
  anew.add(7, folder / "c.vtp");
  CHECK(listed(folder / "run.pvd") == listing{{"7", "c.vtp"}});
}

TEST_CASE("a run may list its frames in any order and each anew", "[io][collection]") {
  const scratch::folder folder;
  io::collection series(folder / "run.pvd");
  series.add(3, folder / "3.vtp");
  series.add(1, folder / "1.vtp");
  series.add(2, folder / "2.vtp");
  series.add(1, folder / "1 again.vtp");
  CHECK(listed(folder / "run.pvd") == listing{{"1", "1 again.vtp"}, {"2", "2.vtp"}, {"3", "3.vtp"}});
  CHECK(scratch::mentions(
      scratch::message<pendular::input_error>([&] { series.add(std::numeric_limits<double>::quiet_NaN(), "x"); }),
      {"time of a frame (s) is nan", "finite", "docs/how-to/paraview.md"}));
  CHECK(listed(folder / "run.pvd").size() == 3);
}

TEST_CASE("names and times come back from the file to the last bit", "[io][collection]") {
  const scratch::folder folder;
  const std::string odd = "frames/0 & 1 <\"2\"> &amp;.vtp";
  const double time = 0.1 + 0.2;
  io::collection(folder / "run.pvd").add(time, folder / odd);
  const std::string before = scratch::content(folder / "run.pvd");
  const io::collection again(folder / "run.pvd");
  REQUIRE(again.entries().size() == 1);
  CHECK(again.entries()[0].time == time);
  CHECK(again.entries()[0].file == folder / odd);
  io::collection(folder / "run.pvd").add(time, folder / odd);
  CHECK(scratch::content(folder / "run.pvd") == before);
}

TEST_CASE("a time that a file lists twice is listed once from then on", "[io][collection]") {
  const scratch::folder folder;
  scratch::write(folder / "run.pvd",
                 "<?xml version=\"1.0\"?>\n<VTKFile byte_order=\"LittleEndian\" type=\"Collection\">\n<Collection>\n"
                 "<DataSet timestep=\"2e-1\" file=\"a.vtp\"/>\n<DataSet file=\"b.vtp\" timestep=\"0.1\"></DataSet>\n"
                 "<DataSet timestep=\"0.2\" part=\"0\" file=\"c.vtp\"/>\n</Collection>\n</VTKFile>\n");
  io::collection series(folder / "run.pvd");
  series.add(0.3, folder / "d.vtp");
  CHECK(listed(folder / "run.pvd") == listing{{"0.1", "b.vtp"}, {"0.2", "c.vtp"}, {"0.3", "d.vtp"}});
}

TEST_CASE("a file that is no list of frames is refused in one sentence and left alone", "[io][collection]") {
  const scratch::folder folder;
  const auto path = folder / "run.pvd";
  const auto said = [&](const std::string& content) {
    scratch::write(path, content);
    const std::string sentence = scratch::message<std::runtime_error>([&] { io::collection series(path); });
    CHECK(scratch::content(path) == content);
    CHECK(scratch::mentions(sentence, {path.string(), "remove it", "docs/how-to/paraview.md"}));
    CHECK(sentence.find('\n') == std::string::npos);
    return sentence;
  };
  const std::string head = "<VTKFile type=\"Collection\">\n<Collection>\n<DataSet timestep=\"0\" file=\"a.vtp\"/>\n";
  const std::string end = "</Collection>\n</VTKFile>\n";
  CHECK(scratch::mentions(said(""), {"VTKFile of type Collection"}));
  CHECK(scratch::mentions(said("t,sigma\n0,1\n"), {"VTKFile of type Collection"}));
  CHECK(scratch::mentions(said("<VTKFile type=\"PolyData\">\n</VTKFile>\n"), {"VTKFile of type Collection"}));
  CHECK(scratch::mentions(said(head), {"no whole VTKFile"}));
  CHECK(scratch::mentions(said(head + "<DataSet file=\"b.vtp\"/>\n" + end), {"no timestep in frame 2"}));
  CHECK(scratch::mentions(said(head + "<DataSet timestep=\"1\"/>\n" + end), {"no file in frame 2"}));
  CHECK(scratch::mentions(said(head + "<DataSet timestep=\"1\" file=\"\"/>\n" + end), {"no file in frame 2"}));
  for (const std::string wrong : {"", "x", "1s", "nan", "inf", "1e999"}) {
    const std::string frame = "<DataSet timestep=\"" + wrong + "\" file=\"b.vtp\"/>\n";
    CHECK(scratch::mentions(said(head + frame + end), {"timestep '" + wrong + "'", "frame 2"}));
  }
  CHECK(scratch::mentions(said(head + "<DataSet timestep=\"1\" part=\"1\" file=\"b.vtp\"/>\n" + end),
                          {"several parts in frame 2"}));
  CHECK(scratch::mentions(scratch::message<std::runtime_error>([&] { io::collection series(folder / "."); }),
                          {"no file that can be read"}));
}

TEST_CASE("a list that is cut off or damaged anywhere is read or refused", "[io][collection]") {
  const scratch::folder folder;
  io::collection first(folder / "run.pvd");
  write_frames(first, folder, 'a', 0, 2);
  const std::string whole = scratch::content(folder / "run.pvd");
  std::size_t refused = 0;
  for (std::size_t k = 0; k < whole.size(); ++k) {
    scratch::write(folder / "cut.pvd", whole.substr(0, k));
    const bool readable =
        scratch::message<std::runtime_error>([&] { io::collection s(folder / "cut.pvd"); }) == "no error";
    CHECK(readable == (k + 1 == whole.size()));  // but for the last end of line
    std::string damaged = whole;
    damaged[k] = '"';
    scratch::write(folder / "cut.pvd", damaged);
    const std::string sentence = scratch::message<std::runtime_error>([&] { io::collection s(folder / "cut.pvd"); });
    CHECK((sentence == "no error" || sentence.starts_with("pendular: '")));
    refused += sentence != "no error";
  }
  CHECK(refused > 0);
}
