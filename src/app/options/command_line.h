#pragma once

// CLI11's own header defines objects, so each source that includes it takes seconds longer to
// compile. Only sources that add or read options include it.
namespace CLI {
class App;
class Option;
class ParseError;
class Validator;
}  // namespace CLI
