// The scale of the colours of a depth picture.
export function DepthScale({ range_m }: { range_m: [number, number] }) {
  const [low, high] = range_m;
  return (
    <div class="depth-scale" role="img" aria-label={`Depth colours: blue ${low} metres, red ${high} metres`}>
      <span class="depth-scale-bar" />
      <span class="depth-scale-labels">
        {[high, (low + high) / 2, low].map((value) => (
          <span key={value}>{value.toFixed(2)} m</span>
        ))}
      </span>
    </div>
  );
}
