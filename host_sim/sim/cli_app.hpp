#pragma once

// All that a header needs of CLI11, whose own header takes seconds to compile; a source that uses it includes that.
namespace CLI {
class App;
}
